// One width for all receivers: soft, and equally soft everywhere.
#include "pcf.glsl"

float softVisibility(Receiver receiver) { return percentageCloser(receiver, soft.filterWidthUv); }
