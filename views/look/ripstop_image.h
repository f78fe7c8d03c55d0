#pragma once

#include <vtkImageData.h>
#include <vtkNew.h>

namespace ripstop {

// A square of ripstop cloth, to be repeated: a faint check crossed by reinforcement threads. It is
// nearly white, and takes the colour of the fabric that it is laid on.
vtkNew<vtkImageData> ripstopImage();

} // namespace ripstop
