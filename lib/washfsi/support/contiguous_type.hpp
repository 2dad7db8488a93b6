// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include <mpi.h>

namespace washfsi {

/// An MPI type of several equal, contiguous items.
class ContiguousType {
 public:
  ContiguousType(std::size_t count, MPI_Datatype of) {
    MPI_Type_contiguous(static_cast<int>(count), of, &type_);
    MPI_Type_commit(&type_);
  }
  ~ContiguousType() { MPI_Type_free(&type_); }
  ContiguousType(const ContiguousType&) = delete;
  ContiguousType& operator=(const ContiguousType&) = delete;
  operator MPI_Datatype() const { return type_; }

 private:
  MPI_Datatype type_ = MPI_DATATYPE_NULL;
};

}  // namespace washfsi
