// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <deal.II/base/polynomials_barycentric.h>
#include <deal.II/base/quadrature_lib.h>

#include <array>
#include <cstdio>
#include <vector>

#include "scene/bernstein.h"

/// Writes primal/reference_products.h's tables, by deal.II: run when the library is built, so that no program has to
/// load deal.II, and all that it brings, to add up a few small matrices.
namespace {

using Slopes = std::array<dealii::BarycentricPolynomial<2>, 2>;

std::vector<Slopes> slopes(int degree) {
  std::vector<Slopes> result;
  for (const auto& i : bracket::scene::bernstein_indices(degree)) {
    dealii::TableIndices<3> powers;
    for (int corner = 0; corner < 3; ++corner) powers[corner] = i[corner];
    const dealii::BarycentricPolynomial<2> polynomial(powers, bracket::scene::trinomial(i));
    result.push_back({polynomial.derivative(0), polynomial.derivative(1)});
  }
  return result;
}

void write(int degree) {
  const std::vector<Slopes> of = slopes(degree);
  const dealii::QWitherdenVincentSimplex<2> quadrature(degree);  // exact up to degree 2 degree − 1
  std::printf("const double products_%d[] = {\n", degree);
  for (int a = 0; a < 2; ++a)
    for (int b = 0; b < 2; ++b)
      for (const Slopes& i : of) {
        for (const Slopes& j : of) {
          double sum = 0;
          for (unsigned int q = 0; q < quadrature.size(); ++q)
            sum += quadrature.weight(q) * i[a].value(quadrature.point(q)) * j[b].value(quadrature.point(q));
          std::printf("%.17g, ", sum);
        }
        std::printf("\n");
      }
  std::printf("};\n");
}

}  // namespace

int main() {
  std::printf("#include \"primal/reference_products.h\"\n\nnamespace bracket::primal {\n\nnamespace {\n\n");
  for (int degree = 1; degree <= 4; ++degree) write(degree);
  std::printf("\n}  // namespace\n\nconst double* reference_products(int degree) {\n");
  std::printf("  constexpr const double* of_degree[] = {products_1, products_2, products_3, products_4};\n");
  std::printf("  return of_degree[degree - 1];\n}\n\n}  // namespace bracket::primal\n");
}
