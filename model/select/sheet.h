// A design as a table, as spreadsheets show one: a row for each thing of a sort, a column for each
// number or word of it. What a cell says and takes, and in which order rows stand.
#pragma once

#include "scene/edit.h"
#include "scene/property.h"

namespace ripstop {

enum class SheetOf { Particles, Links, Lines, Panels, Materials }; // lines are links with that role

Kind kindOf(SheetOf sheet);

// A vector has a column for each axis; the first column, without a property, is the id.
struct SheetColumn
{
    const Property* property = nullptr;
    int axis = 0;
};
std::vector<SheetColumn> sheetColumns(SheetOf sheet);

std::vector<Id> sheetRows(const Scene& scene, SheetOf sheet); // ascending

// What the order of rows by a column depends on, taken out of the scene so that a thread can sort
// it while the scene goes on changing. What has no value comes last, in both directions.
struct SheetKeys
{
    std::vector<Id> ids;            // ascending
    std::vector<double> numbers;    // [ids], not finite where there is none; or
    std::vector<std::string> words; // [ids]
};
enum class SheetOrder { Rising, Falling };
SheetKeys sheetKeys(const Scene& scene, std::vector<Id> ids, const SheetColumn& column);
std::vector<Id> sorted(SheetKeys keys, SheetOrder order); // equals in the order of their ids

// Numbers so that they read back as the same; "" for what is absent; things by name, or as #17.
std::string cellText(const Scene& scene, const ConstRef& thing, const SheetColumn& column);

// The value of the whole property after the text was put into the cell: numbers as typedNumber()
// takes them, things by name or as #17. A message is one sentence without a place.
Result<Value> cellValue(const Scene& scene, Id thing, const SheetColumn& column,
                        const Value& before, std::string_view text);

// A block of cells as spreadsheets copy it: lines, with tabs between cells. It goes into the cells
// to the right of and below the first of `ids` and `columns`; a single cell goes into all of them.
// All or nothing: the message names the line and the column of what does not fit.
Result<Edit> pasted(const Scene& scene, const std::vector<Id>& ids,
                    const std::vector<SheetColumn>& columns, std::string_view block);

} // namespace ripstop
