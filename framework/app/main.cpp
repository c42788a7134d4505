// Compiled into every assignment's program; PENUMBRA_LAYERS are the folders of its variant.
#include "app/app.h"

int main(int argc, char** argv) {
    return penumbra::runAssignment(argc, argv, PENUMBRA_LAYERS, penumbra::makeAssignment);
}
