// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <deal.II/base/polynomials_barycentric.h>
#include <deal.II/base/quadrature_lib.h>

#include <array>
#include <cstdio>
#include <vector>

#include "scene/fields.h"

/// Writes primal/reference_products.h's tables, by deal.II: run when the library is built, so that no program has to
/// load deal.II, and all that it brings, to add up a few small matrices.
namespace {

using bracket::scene::largest_degree_in;

int multinomial(const std::array<int, 3>& i) { return bracket::scene::trinomial(i); }
int multinomial(const std::array<int, 4>& i) { return bracket::scene::quadrinomial(i); }

template <int dim> using Slopes = std::array<dealii::BarycentricPolynomial<dim>, dim>;

template <int dim> std::vector<Slopes<dim>> slopes(int degree) {
  std::vector<Slopes<dim>> result;
  for (const auto& i : bracket::scene::bernstein_indices<dim>(degree)) {
    dealii::TableIndices<dim + 1> powers;
    for (int corner = 0; corner <= dim; ++corner) powers[corner] = i[corner];
    const dealii::BarycentricPolynomial<dim> polynomial(powers, multinomial(i));
    Slopes<dim> of_one;
    for (int a = 0; a < dim; ++a) of_one[a] = polynomial.derivative(a);
    result.push_back(of_one);
  }
  return result;
}

template <int dim> void write(int degree) {
  const std::vector<Slopes<dim>> of = slopes<dim>(degree);
  const dealii::QWitherdenVincentSimplex<dim> quadrature(degree);  // exact up to degree 2 degree − 1
  std::printf("const double products_%d_%d[] = {\n", dim, degree);
  for (int a = 0; a < dim; ++a)
    for (int b = 0; b < dim; ++b)
      for (const Slopes<dim>& i : of) {
        for (const Slopes<dim>& j : of) {
          double sum = 0;
          for (unsigned int q = 0; q < quadrature.size(); ++q)
            sum += quadrature.weight(q) * i[a].value(quadrature.point(q)) * j[b].value(quadrature.point(q));
          std::printf("%.17g, ", sum);
        }
        std::printf("\n");
      }
  std::printf("};\n");
}

template <int dim> void write_choice() {
  std::printf("template <> const double* reference_products<%d>(int degree) {\n", dim);
  std::printf("  constexpr const double* of_degree[] = {");
  for (int degree = 1; degree <= largest_degree_in<dim>(); ++degree) std::printf("products_%d_%d, ", dim, degree);
  std::printf("};\n  return of_degree[degree - 1];\n}\n");
}

}  // namespace

int main() {
  std::printf("#include \"primal/reference_products.h\"\n\nnamespace bracket::primal {\n\nnamespace {\n\n");
  for (int degree = 1; degree <= largest_degree_in<2>(); ++degree) write<2>(degree);
  for (int degree = 1; degree <= largest_degree_in<3>(); ++degree) write<3>(degree);
  std::printf("\n}  // namespace\n\n");
  write_choice<2>();
  write_choice<3>();
  std::printf("\n}  // namespace bracket::primal\n");
}
