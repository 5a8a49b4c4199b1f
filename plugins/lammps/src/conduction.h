// Heat that a contact conducts.
#ifndef CAROM_CONDUCTION_H
#define CAROM_CONDUCTION_H

#include <cmath>

namespace carom {

// H = 2 k a (T_2 - T_1) into body 1: two half-spaces that are joined in a circle of radius a (Holm). Hertz's contact has
// a^2 = R zeta, with the relative curvature 1/R; of an ellipse the mean of both curvatures.
inline double conducted(double conductivity, double curvature, double overlap, double difference)
{
  if (!(overlap > 0.0)) return 0.0;
  return 2.0 * conductivity * std::sqrt(overlap / curvature) * difference;
}

}    // namespace carom

#endif
