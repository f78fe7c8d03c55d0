// The picture of cloth that is laid on panels whose particles have places on it.
//
// It is computed, as a file of it would only have to be found and read. The panel layer asks once,
// when it is made.
#pragma once

#include <vtkImageData.h>
#include <vtkNew.h>

namespace ripstop {

// A square of ripstop cloth of 512 by 512 pixels, RGB, to be repeated: a faint check crossed by
// reinforcement threads. It is nearly white, so that it takes the colour of the fabric that it is
// laid on.
vtkNew<vtkImageData> ripstopImage();

} // namespace ripstop
