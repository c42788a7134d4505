#include "scene/gltf.h"
