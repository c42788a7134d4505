vec2 kernelPoint(vec2 cell, float inverse) { return (cell + 0.5) * inverse - 0.5; }
