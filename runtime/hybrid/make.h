// The classifiers, one file each; techniques.cpp lists them.
#pragma once

#include "runtime/hybrid/classifier.h"

namespace gnomon {

std::unique_ptr<Classifier> make_nothing(Resources& resources); // nothing.cpp

} // namespace gnomon
