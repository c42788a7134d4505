// Fails: Task7Kernels.EverySampleHasARowAndAColumnOfItsOwn · columns are not moved along
vec2 shearedGrid(vec2 cell, float inverse) { return (cell + vec2((cell.y + 0.5) * inverse, 0.5)) * inverse - 0.5; }

vec2 diskFromSquare(vec2 square) {
    bool wide = abs(square.x) > abs(square.y);
    float side = wide ? square.x : square.y, along = wide ? square.y : square.x;
    if (side == 0.0) return vec2(0.0);
    float radius = side * 1.1283791671, angle = 0.7853981634 * along / side;  // 2 / sqrt(pi), pi / 4
    vec2 point = radius * vec2(cos(angle), sin(angle));
    return wide ? point : point.yx;
}
