#include "core/import/file_space.h"

namespace prizma {

glm::dmat4 fileToObject(UpAxis upAxis, double unitScale) {
    glm::dmat4 matrix(1.0);
    if (upAxis == UpAxis::Z)
        matrix = {{1, 0, 0, 0}, {0, 0, -1, 0}, {0, 1, 0, 0}, {0, 0, 0, 1}};
    for (int column = 0; column < 3; ++column)
        matrix[column] *= unitScale;
    return matrix;
}

} // namespace prizma
