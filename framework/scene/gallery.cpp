#include "scene/gallery.h"
