#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes the manual pages and the completion of options from what the program tells of itself.

    cmake/write_manual.py build/bin/washfsi build/manual scripts/report scripts/plot
"""

import ast
import os
import pathlib
import re
import subprocess
import sys
import tempfile

TEMPLATE = pathlib.Path(__file__).resolve().parent / "completion.bash.in"
ROW = re.compile(r"^\| `-(\w+)` \| (.*?) \| (.*?) \| (.*?) \| (.*) \|$")
CHOICE = re.compile(r"[\w.+-]+(, [\w.+-]+)+")
OF_PETSC = ["-help", "-version", "-options_file", "-options_left", "-log_view"]
DESCRIPTION = """washfsi simulates cloth that moves in the water of a washing machine: incompressible flow on a staggered
grid, cloth by the immersed boundary method, drum and agitator as rigid bodies. A case is a file of options; options on the
command line override those of the file. The number of values of -grid_cells, 2 or 3, decides on a plane or a run in space."""
EXAMPLES = [("washfsi -options_file {inputs}/cavity.opts", "a small case"),
            ("mpirun -n 2 washfsi -options_file {inputs}/wash.opts -time_end 0.2", "a washing machine on two processes"),
            ("washfsi -options_file {inputs}/wash.opts -check -output_dir check", "what a run will cost, and how far to believe it"),
            ("washfsi-report out", "its report, one HTML file")]
STATUS = [("0", "the run has finished, or was stopped by a signal and wrote a checkpoint"),
          ("1", "an error of the program"), ("2", "a mistake in the options or the input files"),
          ("3", "the run has diverged"), ("4", "a file cannot be written")]


def ask(program, *words):
    """Returns what the program prints."""
    with tempfile.TemporaryDirectory() as folder:
        return subprocess.run([program, *words], check=True, capture_output=True, text=True, cwd=folder,
                              env={**os.environ, "OMPI_MCA_btl": "self"}).stdout


def blocks_of(listing):
    """Returns the options by blocks, title -> [(name, unit, values, default, meaning)], without the old names."""
    blocks, title = {}, ""
    for line in listing.splitlines():
        if line.startswith("## "):
            title = line[3:]
        elif row := ROW.match(line):
            blocks.setdefault(title, []).append(row.groups())
    return blocks


def roff(text):
    """Returns a text as roff takes it literally."""
    text = text.replace("\\", "\\e").replace("-", "\\-").replace("`", "")
    return re.sub(r"^([.'])", r"\\&\1", text, flags=re.M)


def head(name, version, what):
    """Returns the beginning of a manual page."""
    return f'.TH {name.upper()} 1 "" "washfsi {version}" "washfsi"\n.SH NAME\n{roff(name)} \\- {roff(what)}\n'


def option_text(name, unit, values, default, meaning):
    """Returns the paragraph of an option."""
    facts = [values if unit in ("", "-") or not values else f"{values} [{unit}]", default if default in ("", "required") else f"default: {default}"]
    told = "; ".join(filter(None, facts))
    return f".TP\n.B \\-{roff(name)}\n{roff(meaning)}" + (f" ({roff(told)})" if told else "") + "\n"


def page_of_program(blocks, version):
    """Returns the manual page of washfsi."""
    text = head("washfsi", version, "cloth and water in a washing machine")
    text += ".SH SYNOPSIS\n.B washfsi\n\\-options_file\n.I CASE.opts\n.RI [ \"\\-option value\" \" ...]\"\n.br\n"
    text += ".B mpirun \\-n\n.I N\n.B washfsi\n\\-options_file\n.I CASE.opts\n"
    text += f".SH DESCRIPTION\n{roff(DESCRIPTION)}\n.SH OPTIONS\n"
    text += "BODY, CLOTH and LINE stand for the names given to \\-bodies, \\-cloths and \\-profiles. PETSc's options come in addition.\n"
    for title, options in blocks.items():
        text += f".SS {roff(title)}\n" + "".join(option_text(*option) for option in options)
    text += ".SH EXAMPLES\n" + "".join(f".TP\n.B {roff(line.format(inputs='/usr/share/washfsi/inputs'))}\n{what}\n"
                                       for line, what in EXAMPLES)
    text += ".SH EXIT STATUS\n" + "".join(f".TP\n.B {status}\n{what}\n" for status, what in STATUS)
    return text + ".SH SEE ALSO\n.BR washfsi\\-report (1),\n.BR washfsi\\-plot (1),\n.BR washfsi\\-study (1),\n.BR mpirun (1)\n"


def page_of_script(path, version):
    """Returns the manual page of a script, from its docstring."""
    told = ast.get_docstring(ast.parse(path.read_text(encoding="utf-8"))).replace("scripts/", "washfsi-")
    first = told.split(".", 1)[0].split("\n\n")[0].replace("\n", " ")
    text = head(f"washfsi-{path.name}", version, first[0].lower() + first[1:])
    text += f".SH SYNOPSIS\n.B washfsi\\-{roff(path.name)}\n.I ARGUMENTS\n.SH DESCRIPTION\n.nf\n{roff(told)}\n.fi\n"
    return text + f".PP\n.B washfsi\\-{roff(path.name)} \\-\\-help\nlists its arguments.\n.SH SEE ALSO\n.BR washfsi (1)\n"


def choices_of(values):
    """Returns what an option may be, in the plane or in space, as words; none if it is no choice."""
    lists = re.split("; 3D: ", values)
    return " ".join(dict.fromkeys(", ".join(lists).split(", "))) if all(map(CHOICE.fullmatch, lists)) else ""


def completion(blocks):
    """Returns the completion of options for bash."""
    options = [option for rows in blocks.values() for option in rows]
    names = dict.fromkeys([f"-{option[0]}" for option in options] + OF_PETSC)
    choices = {f"-{name}": words for name, _, values, _, _ in options if (words := choices_of(values))}
    listed = "\n".join(f'  [{name}]="{values}"' for name, values in choices.items())
    return TEMPLATE.read_text(encoding="utf-8").replace("@OPTIONS@", "\n".join(names)).replace("@CHOICES@", listed)


def main():
    """Writes all files."""
    program, folder, *scripts = (pathlib.Path(word) for word in sys.argv[1:])
    folder.mkdir(parents=True, exist_ok=True)
    blocks = blocks_of(ask(program.resolve(), "-document", "options"))
    version = ask(program.resolve(), "-version").split()[1]
    pages = {"washfsi.1": page_of_program(blocks, version), "washfsi.bash": completion(blocks)}
    pages |= {f"washfsi-{script.name}.1": page_of_script(script, version) for script in scripts}
    for name, text in pages.items():
        (folder / name).write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
