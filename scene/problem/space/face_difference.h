// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// In space: what is left out where a function on a face is fixed by three values, as scene/problem/difference.h has it
// on edges.
#pragma once

#include <vector>

#include "scene/problem/space/face.h"

namespace bracket::scene {

/// Four triangles of half the size.
std::array<FacePart, 4> quarters(const FacePart& part);

/// Sixteen parts; where the function is not smooth they are quartered towards that, 32 times. One part, where the
/// function is linear for sure; sixteen, where it is but sampled.
std::vector<FacePart> parts_of(const Function<3>& given, const Face& face);

/// A point of a part at each of a product of Gauss' rules, its square folded to a triangle: all inside of it.
struct FacePoint {
  OnFace at;
  double weight;  ///< by the area of the part
};
std::vector<FacePoint> points_in(const FacePart& part);

inline double value_on_face(const std::array<double, 3>& corners, const OnFace& at) {
  return corners[0] + at[0] * (corners[1] - corners[0]) + at[1] * (corners[2] - corners[0]);
}

/// On a part: the difference of a function and a polynomial on the face.
struct FaceDifference {
  FacePart part;
  double largest;  ///< not less than its magnitude; of a sampled function, that at points
  double slope;    ///< the same of the magnitude of its gradient along the face; infinite where that has no bound
  double value;    ///< as `largest`, of the function itself
};
/// \param corners the values of a linear function
FaceDifference difference(const Function<3>& given, const Face& face, const FacePart& part,
                          const std::array<double, 3>& corners);
/// On parts_of() the face, or, of another quadratic, all of it. \param quadratic its Bernstein coefficients, as
/// FacetQuadratic<3> has them
std::vector<FaceDifference> difference(const Function<3>& given, const Face& face,
                                       const std::array<double, 6>& quadratic);

/// What rounding does to values of about `largest` on a face, which differ as the coefficients of the quadratic do, and
/// to the points at which they are taken: a difference that is no larger is none.
double rounding_of_values(double largest, const std::array<double, 6>& quadratic, const Face& face);

}  // namespace bracket::scene
