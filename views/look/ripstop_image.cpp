#include "look/ripstop_image.h"

#include <algorithm>

namespace ripstop {
namespace {

constexpr int size = 512; // pixels
constexpr int cells = 8;  // checks per side
constexpr int cell = size / cells;
constexpr int thread = 5; // pixels

int shade(int x, int y)
{
    const int inX = x % cell, inY = y % cell;
    const bool check = (x / cell + y / cell) % 2 == 0;
    int value = check ? 255 : 226;
    if (inX < thread || inY < thread)
        value -= 44;
    if ((x / 2 + y / 2) % 2 == 0) // the weave
        value -= 3;
    return std::max(0, value);
}

} // namespace

vtkNew<vtkImageData> ripstopImage()
{
    vtkNew<vtkImageData> image;
    image->SetDimensions(size, size, 1);
    image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
    auto* pixel = static_cast<unsigned char*>(image->GetScalarPointer());
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x, pixel += 3)
            std::fill_n(pixel, 3, static_cast<unsigned char>(shade(x, y)));
    return image;
}

} // namespace ripstop
