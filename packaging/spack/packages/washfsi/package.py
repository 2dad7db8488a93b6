# SPDX-License-Identifier: BSD-3-Clause
from spack.package import *


class Washfsi(CMakePackage):
    """Cloth and water in a washing machine: incompressible flow on a staggered grid, cloth by the immersed boundary
    method, drum and agitator as rigid bodies, on PETSc and MPI."""

    license("BSD-3-Clause")

    # Built from a source tree: spack dev-build washfsi@0.2.0 (docs/install.md).
    version("0.2.0")

    variant("native", default=False, description="Optimise for the very processor of the build, beyond Spack's target")
    variant("python", default=True, description="Depend on what the Python module and the scripts need")

    depends_on("c", type="build")
    depends_on("cxx", type="build")
    depends_on("cmake@3.23:", type="build")
    depends_on("pkgconfig", type="build")
    depends_on("python@3.11:", type=("build", "run"))
    depends_on("mpi")
    depends_on("petsc@3.18: +mpi+double~complex")
    depends_on("hdf5@1.10: +mpi+hl")
    depends_on("fftw@3.3: precision=double")
    depends_on("eigen@3.4:3")
    depends_on("nlohmann-json@3.11:")
    depends_on("embree@3.13:3")
    for module in ("py-numpy", "py-h5py", "py-matplotlib", "py-pillow"):
        depends_on(module, type="run", when="+python")

    extends("python", when="+python")

    def patch(self):
        # The scripts ask for Debian's Python.
        for script in ("report", "plot", "study", "paraview", "write-agitator"):
            filter_file("#!/usr/bin/python3", "#!/usr/bin/env python3", f"scripts/{script}", string=True)

    def cmake_args(self):
        return [
            self.define_from_variant("WASHFSI_NATIVE", "native"),
            self.define("WASHFSI_WARNINGS_ARE_ERRORS", False),
            self.define("BUILD_TESTING", False),
            self.define("Python3_EXECUTABLE", self.spec["python"].command.path),
            self.define("WASHFSI_PYTHON_DIR", join_path("lib", f"python{self.spec['python'].version.up_to(2)}", "site-packages")),
        ]

    def test_cavity(self):
        """The installed program runs a cavity."""
        washfsi = which(self.prefix.bin.washfsi)
        washfsi("-options_file", join_path(self.prefix.share, "washfsi", "inputs", "cavity.opts"), "-max_steps", "5")
