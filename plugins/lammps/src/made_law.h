// The library's law of the contacts of two materials; copies share it.
#ifndef CAROM_MADE_LAW_H
#define CAROM_MADE_LAW_H

#include "carom.h"

#include <memory>

namespace carom {

using MadeLaw = std::shared_ptr<const carom_law>;

// Heat by any cause.
inline double all_of(const carom_heats &heats)
{
  return heats.friction + heats.damping + heats.rolling;
}

}    // namespace carom

#endif
