// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// In space: functions on a face.
#include "scene/problem/space/face.h"

namespace bracket::scene {

namespace {

Interval coordinate(const Face& face, int c, const OnFace& at) {
  if (at[0] == 1) return face[1][c];
  if (at[1] == 1) return face[2][c];
  Interval x = face[0][c];
  for (int i = 0; i < 2; ++i)
    if (at[i] != 0) x = x + Interval(at[i]) * (Interval(face[i + 1][c]) - Interval(face[0][c]));
  return x;
}

Interval along_axis(const Face& face, int c, const OnFace& direction) {
  Interval x;
  for (int i = 0; i < 2; ++i) x = x + Interval(direction[i]) * (Interval(face[i + 1][c]) - Interval(face[0][c]));
  return x;
}

}  // namespace

Jet over_part(const Function<3>& f, const Face& face, const FacePart& part, const OnFace& direction) {
  Function<3>::Range x;
  for (int c = 0; c < 3; ++c) {
    const Interval box =
        hull(hull(coordinate(face, c, part[0]), coordinate(face, c, part[1])), coordinate(face, c, part[2]));
    x[c] = {box, along_axis(face, c, direction), {}, {}};
  }
  return f.over(x);
}

Jet at_point(const Function<3>& f, const Face& face, const OnFace& at, const OnFace& direction) {
  Function<3>::Range x;
  for (int c = 0; c < 3; ++c) {
    const Interval slope = along_axis(face, c, direction);
    x[c] = {coordinate(face, c, at), slope, {}, {}};
    if (x[c].value().is_point() && !slope.is_zero()) x[c].side = 1;
  }
  return f.over(x);
}

// A form of degree n in two variables is zero if it is in n + 1 directions.
bool is_polynomial(const Function<3>& f, const Face& face, int degree) {
  if (!f.is_enclosed()) return false;
  for (const OnFace& direction : {OnFace{2, 1}, OnFace{1, 2}, OnFace{3, 1}, OnFace{1, 3}}) {
    const Jet jet = over_part(f, face, whole_face, direction);
    if (jet.partial || !jet.value().is_bounded()) return false;
    for (int n = degree + 1; n <= 3; ++n)
      if (!jet.c[n].is_zero()) return false;
  }
  return true;
}

}  // namespace bracket::scene
