#include "cli/json_values.h"

namespace ripstop {

Json jsonOf(const Value& value)
{
    struct Converter
    {
        Json operator()(std::monostate) const { return nullptr; }
        Json operator()(bool flag) const { return flag; }
        Json operator()(int number) const { return number; }
        Json operator()(double number) const { return number; }
        Json operator()(const std::string& text) const { return text; }
        Json operator()(const Vec3& v) const { return {v.x(), v.y(), v.z()}; }
        Json operator()(Id id) const { return id == noId ? Json() : Json(std::uint32_t(id)); }
        Json operator()(const std::vector<Id>& ids) const
        {
            Json numbers = Json::array();
            for (const Id id : ids)
                numbers.push_back(std::uint32_t(id));
            return numbers;
        }
        Json operator()(const NumberRows& rows) const { return rows; }
    };
    return std::visit(Converter{}, value);
}

} // namespace ripstop
