#include "truth/visibility.h"
