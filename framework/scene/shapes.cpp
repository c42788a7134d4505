#include "scene/shapes.h"
