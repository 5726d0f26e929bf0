#include "rigid/frame_derivatives.hpp"

namespace rigid {

Vector3d point_on_screw_axis(const Vector3d& r, const Vector3d& v, const Vector3d& omega) {
  // With p across ω, v_p = v_at_origin + ω × p is parallel to ω if ω × v_at_origin = −ω × (ω × p) = ω² p.
  const Vector3d v_at_origin = v - omega.cross(r);
  return omega.cross(v_at_origin) / omega.squaredNorm();
}

}  // namespace rigid
