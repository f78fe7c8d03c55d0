// The question for the table of a measured wind (io/wind_record.h), and what is in it. In the
// thread of the window.
#pragma once

#include "base/result.h"
#include "scene/items.h"

#include <optional>

class QWidget;

namespace ripstop {

class Document;

// Nothing when the user thinks better of it. It begins in the folder of the scene.
std::optional<Result<NumberRows>> askWindRecord(QWidget* parent, const Document& document);

} // namespace ripstop
