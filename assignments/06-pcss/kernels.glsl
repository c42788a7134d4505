// Task 7a · n x n samples of [-1/2, 1/2]² of which no two share a row or a column.         README §7
//   cell      (i, j), each of 0 … n - 1
//   inverse   1 / n
// Returns a point in the cell (i, j) of a grid of n x n, counted from that cell's lower left corner: j / n² + 1 / (2 n²)
// along x, the same for all of row j, and i / n² + 1 / (2 n²) along y, the same for all of column i. So n² different
// places meet an edge along either axis, not n.
vec2 shearedGrid(vec2 cell, float inverse) {
    return (cell + 0.5) * inverse - 0.5;  // yours; this is the plain grid
}

// Task 7b · the square's points on a disk of the same area.                                README §7, [Shirley & Chiu 1997]
//   square   in [-1/2, 1/2]²
// Returns a point of the disk around 0 with area 1: squares around 0 become circles around 0, and equal areas stay
// equal. Axes stay where they are; (0, 0) stays (0, 0).
vec2 diskFromSquare(vec2 square) {
    return square;  // yours
}
