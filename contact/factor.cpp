// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/factor.h"

#include <cholmod.h>
#include <dlfcn.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <mutex>
#include <new>
#include <stdexcept>

#include "contact/contact.h"
#include "contact/large_array.h"

namespace bracket::contact {
namespace {

/// Looked up, so that any other BLAS does as well.
void set_blas_threads(int count) {
  using Set = void(int);
  if (void* set = dlsym(RTLD_DEFAULT, "openblas_set_num_threads")) reinterpret_cast<Set*>(set)(count);
}

/// A lower triangle as CHOLMOD sees it; it only reads. \param begin of each column, and their end
cholmod_sparse view(std::size_t n, const int* begin, const int* rows, const double* values, bool sorted) {
  cholmod_sparse result{};
  result.nrow = result.ncol = n;
  result.nzmax = begin[n];
  result.p = const_cast<int*>(begin);
  result.i = const_cast<int*>(rows);
  result.x = const_cast<double*>(values);
  result.stype = -1;
  result.itype = CHOLMOD_INT;
  result.xtype = CHOLMOD_REAL;
  result.dtype = CHOLMOD_DOUBLE;
  result.sorted = sorted;
  result.packed = 1;
  return result;
}

/// The lower triangle of P K Pᵀ, rows in any order. CHOLMOD itself would transpose K twice for it.
struct Permuted {
  std::vector<int> begin;
  LargeArray<int> rows;
  LargeArray<double> values;
};

/// \param unknown that comes k-th, k = 0 …   \param pinned as Factor::factorise() has them
Permuted permuted(const Eigen::SparseMatrix<double>& stiffness, const int* unknown, const std::vector<int>& pinned) {
  const int n = static_cast<int>(stiffness.cols());
  std::vector<int> place(n);
  for (int k = 0; k < n; ++k) place[unknown[k]] = k;
  std::vector<char> is_pinned(n, 0);
  for (const int i : pinned) is_pinned[i] = 1;

  using Entry = Eigen::SparseMatrix<double>::InnerIterator;
  const auto room = static_cast<std::size_t>(stiffness.nonZeros()) + 1;  // CHOLMOD takes no null pointers
  Permuted result{std::vector<int>(n + 1, 0), LargeArray<int>(room), LargeArray<double>(room)};
  for (int j = 0; j < n; ++j)
    for (Entry entry(stiffness, j); entry; ++entry) ++result.begin[std::min(place[j], place[entry.row()]) + 1];
  for (int k = 0; k < n; ++k) result.begin[k + 1] += result.begin[k];
  std::vector<int> next(result.begin.begin(), result.begin.end() - 1);
  for (int j = 0; j < n; ++j)
    for (Entry entry(stiffness, j); entry; ++entry) {
      const int i = static_cast<int>(entry.row());
      const int at = next[std::min(place[j], place[i])]++;
      result.rows[at] = std::max(place[j], place[i]);
      result.values[at] = i != j && (is_pinned[i] || is_pinned[j]) ? 0 : entry.value();
    }
  return result;
}

/// A supernodal factor: its columns super[s] … super[s+1]−1 share the rows s[pi[s]] … s[pi[s+1]−1] and lie one after
/// the other, from x[px[s]] on.
struct Supernodes {
  const int *super, *row_begin, *rows, *value_begin;
  const double* values;
  int count;

  explicit Supernodes(const cholmod_factor& factor)
      : super(static_cast<const int*>(factor.super)),
        row_begin(static_cast<const int*>(factor.pi)),
        rows(static_cast<const int*>(factor.s)),
        value_begin(static_cast<const int*>(factor.px)),
        values(static_cast<const double*>(factor.x)),
        count(static_cast<int>(factor.nsuper)) {}
  int height(int s) const { return row_begin[s + 1] - row_begin[s]; }
  /// Column c of L, from the first row of its supernode on.
  const double* column(int s, int c) const {
    return values + value_begin[s] + static_cast<std::ptrdiff_t>(c - super[s]) * height(s);
  }
};

/// A column of L that belongs to one of the last unknowns, from its diagonal entry on. CHOLMOD may reorder subtrees,
/// but a column stays before those that depend on it: none outside depends on the last ones, so that where its rows are
/// not theirs its values are zero.
struct LastColumn {
  int place;    ///< in the factor
  int unknown;  ///< there
  int count;
  const int* rows;
  const double* values;
};

/// The unknown that comes k-th.
std::vector<int> order(const std::vector<int>& nodes, const std::vector<int>& sequence, const std::vector<int>& last,
                       const std::vector<char>& is_last) {
  std::vector<int> result;
  result.reserve(is_last.size());
  for (std::size_t k = 0; k + 1 < nodes.size(); ++k) {
    const int node = sequence.empty() ? static_cast<int>(k) : sequence[k];
    for (int i = nodes[node]; i < nodes[node + 1]; ++i)
      if (!is_last[i]) result.push_back(i);
  }
  result.insert(result.end(), last.begin(), last.end());
  return result;
}

}  // namespace

struct Factor::Handle {
  cholmod_common common;
  cholmod_factor* factor = nullptr;
  std::vector<char> is_last;

  Eigen::VectorXd solved(int system, const Eigen::VectorXd& b) const;  ///< as cholmod_solve() numbers systems
  std::vector<LastColumn> last_columns() const;                        ///< in their order in the factor

  Handle() {
    cholmod_start(&common);
    common.print = 0;
    common.supernodal = CHOLMOD_SUPERNODAL;
    common.nmethods = 1;
    common.method[0].ordering = CHOLMOD_GIVEN;
  }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  ~Handle() {
    cholmod_free_factor(&factor, &common);
    cholmod_finish(&common);
  }
};

Factor::Factor(Factor&&) noexcept = default;
Factor& Factor::operator=(Factor&&) noexcept = default;
Factor::~Factor() = default;

Factor::Factor(const Eigen::SparseMatrix<double>& stiffness, const std::vector<int>& nodes,
               const std::vector<int>& sequence, const std::vector<int>& last)
    : handle_(std::make_unique<Handle>()) {
  if (stiffness.rows() == 0) return;  // CHOLMOD takes no empty matrix
  handle_->is_last.assign(stiffness.rows(), 0);
  for (int i : last) handle_->is_last[i] = 1;
  std::vector<int> permutation = order(nodes, sequence, last, handle_->is_last);
  cholmod_sparse matrix =
      view(stiffness.cols(), stiffness.outerIndexPtr(), stiffness.innerIndexPtr(), stiffness.valuePtr(), true);
  handle_->factor = cholmod_analyze_p(&matrix, permutation.data(), nullptr, 0, &handle_->common);
  if (!handle_->factor) throw std::bad_alloc();
}

double physical_memory() { return static_cast<double>(sysconf(_SC_PHYS_PAGES)) * sysconf(_SC_PAGESIZE); }

double Factor::entries() const {
  const cholmod_factor* factor = handle_->factor;
  return factor ? static_cast<double>(factor->xsize) + static_cast<double>(factor->maxcsize) : 0;
}

bool Factor::factorise(const Eigen::SparseMatrix<double>& stiffness, const std::vector<int>& pinned) {
  if (stiffness.rows() == 0) return true;
  const int* const unknown = static_cast<const int*>(handle_->factor->Perm);
  {
    const Permuted k = permuted(stiffness, unknown, pinned);
    cholmod_sparse matrix = view(stiffness.cols(), k.begin.data(), k.rows.data(), k.values.data(), false);
    if (handle_->factor->xtype == CHOLMOD_PATTERN) {  // the memory of L, as CHOLMOD would take it itself
      if (!cholmod_change_factor(CHOLMOD_REAL, 1, 1, 1, 1, handle_->factor, &handle_->common)) throw std::bad_alloc();
      use_large_pages(static_cast<double*>(handle_->factor->x), handle_->factor->xsize);
    }
    double nothing_added[2] = {0, 0};
    // CHOLMOD asks OpenMP for four threads for every supernode, whatever else runs: they wait for each other in loops.
#pragma omp teams num_teams(1) thread_limit(1)
    cholmod_super_numeric(&matrix, nullptr, nothing_added, handle_->factor, &handle_->common);
  }
  if (handle_->common.status < CHOLMOD_OK) throw std::bad_alloc();  // not definite: a warning, above it
  const cholmod_factor& factor = *handle_->factor;
  if (factor.minor < factor.n) return false;
  // A singular matrix need not give a pivot ≤ 0: in rounding a small one may remain, of either sign.
  constexpr double lost = 1e-13;
  const Eigen::VectorXd diagonal = stiffness.diagonal();
  const Supernodes nodes(factor);
  for (int s = 0; s < nodes.count; ++s)
    for (int c = nodes.super[s]; c < nodes.super[s + 1]; ++c) {
      const double pivot = nodes.column(s, c)[c - nodes.super[s]];
      if (!(pivot * pivot > lost * diagonal[unknown[c]])) return false;
    }
  return true;
}

Eigen::VectorXd Factor::Handle::solved(int system, const Eigen::VectorXd& b) const {
  cholmod_dense right{};
  right.nrow = right.d = right.nzmax = b.size();
  right.ncol = 1;
  right.x = const_cast<double*>(b.data());
  right.xtype = CHOLMOD_REAL;
  right.dtype = CHOLMOD_DOUBLE;
  cholmod_common own;  // its own workspace, so that several threads may solve at once
  cholmod_start(&own);
  own.print = 0;
  cholmod_dense* solution = cholmod_solve(system, factor, &right, &own);
  Eigen::VectorXd result;
  if (solution) result = Eigen::Map<Eigen::VectorXd>(static_cast<double*>(solution->x), b.size());
  cholmod_free_dense(&solution, &own);
  cholmod_finish(&own);
  if (result.size() == 0) throw std::bad_alloc();
  return result;
}

Eigen::VectorXd Factor::forward(const Eigen::VectorXd& b) const {
  if (b.size() == 0) return b;
  return handle_->solved(CHOLMOD_L, handle_->solved(CHOLMOD_P, b));
}

Eigen::VectorXd Factor::backward(const Eigen::VectorXd& y) const {
  if (y.size() == 0) return y;
  return handle_->solved(CHOLMOD_Pt, handle_->solved(CHOLMOD_Lt, y));
}

std::vector<LastColumn> Factor::Handle::last_columns() const {
  std::vector<LastColumn> columns;
  const int* const unknown = static_cast<const int*>(factor->Perm);
  const Supernodes nodes(*factor);
  for (int s = 0; s < nodes.count; ++s)
    for (int c = nodes.super[s]; c < nodes.super[s + 1]; ++c)
      if (is_last[unknown[c]]) {
        const int above = c - nodes.super[s];
        columns.push_back({c, unknown[c], nodes.height(s) - above, nodes.rows + nodes.row_begin[s] + above,
                           nodes.column(s, c) + above});
      }
  return columns;
}

Eigen::VectorXd Factor::plus_last(Eigen::VectorXd y, const Eigen::VectorXd& b) const {
  if (y.size() == 0) return y;
  Eigen::VectorXd added = Eigen::VectorXd::Zero(y.size());
  const std::vector<LastColumn> columns = handle_->last_columns();
  for (const LastColumn& column : columns) added[column.place] = b[column.unknown];
  for (const auto& [place, unknown, count, rows, values] : columns) {
    added[place] /= values[0];
    for (int k = 1; k < count; ++k) added[rows[k]] -= values[k] * added[place];
    y[place] += added[place];
  }
  return y;
}

Eigen::VectorXd Factor::backward_to_last(const Eigen::VectorXd& y) const {
  if (y.size() == 0) return y;
  Eigen::VectorXd ordered = Eigen::VectorXd::Zero(y.size()), result = ordered;
  const std::vector<LastColumn> columns = handle_->last_columns();
  for (auto column = columns.rbegin(); column != columns.rend(); ++column) {
    const auto& [place, unknown, count, rows, values] = *column;
    double rest = y[place];
    for (int k = 1; k < count; ++k) rest -= values[k] * ordered[rows[k]];
    result[unknown] = ordered[place] = rest / values[0];
  }
  return result;
}

Trailing Factor::trailing() const {
  if (handle_->is_last.empty()) return {};
  const std::vector<LastColumn> columns = handle_->last_columns();
  Trailing result;
  std::vector<int> row_at(handle_->factor->n, -1);  // of `lower`, by the place in the factor
  for (const LastColumn& column : columns) {
    row_at[column.place] = static_cast<int>(result.unknowns.size());
    result.unknowns.push_back(column.unknown);
  }
  result.lower.setZero(result.unknowns.size(), result.unknowns.size());
  for (const auto& [place, unknown, count, rows, values] : columns)
    for (int k = 0; k < count; ++k) {
      if (row_at[rows[k]] >= 0)
        result.lower(row_at[rows[k]], row_at[place]) = values[k];
      else if (values[k] != 0)
        throw std::logic_error("the contact unknowns are not last in the factor");
    }
  return result;
}

BlasThreads::BlasThreads(int count) : before_(now()) { set_blas_threads(count); }

BlasThreads::~BlasThreads() { set_blas_threads(before_); }

int BlasThreads::now() {
  using Get = int();
  void* const get = dlsym(RTLD_DEFAULT, "openblas_get_num_threads");
  return get ? reinterpret_cast<Get*>(get)() : 0;
}

void reserve_blas_memory(int callers) {
  using Take = void*(int);
  using Give = void(void*);
  void* const take = dlsym(RTLD_DEFAULT, "blas_memory_alloc");  // OpenBLAS's own; another BLAS takes no such buffers
  void* const give = dlsym(RTLD_DEFAULT, "blas_memory_free");
  if (!take || !give) return;
  static std::mutex reserving;
  static int reserved = 0;
  const std::lock_guard<std::mutex> lock(reserving);
  if (reserved >= callers) return;
  constexpr std::size_t buffer = std::size_t{128} << 20;  // what OpenBLAS 0.3.21 takes for each caller
  const std::size_t size = callers * buffer;
  void* const room = mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (room == MAP_FAILED) throw std::bad_alloc();
  munmap(room, size);
  std::vector<void*> buffers(callers);
  for (void*& taken : buffers) taken = reinterpret_cast<Take*>(take)(0);
  for (void* taken : buffers) reinterpret_cast<Give*>(give)(taken);  // it keeps them for later calls
  reserved = callers;
}

}  // namespace bracket::contact
