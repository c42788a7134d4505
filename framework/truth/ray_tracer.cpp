#include "truth/ray_tracer.h"
