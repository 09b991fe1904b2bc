// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "hmi/model/zip_archive.hpp"
#include "shared/base/result.hpp"

namespace psicarve::model {

/// The attributes of one element. Names of another name space than the element's stand as "URI name".
class XmlAttributes {
public:
    explicit XmlAttributes(const char** names_and_values) : pairs_(names_and_values) {}
    std::optional<std::string_view> find(std::string_view name) const noexcept;

private:
    const char** pairs_;
};

/// Called where an element begins. `space` is its name space's URI, empty without one.
using ElementTaker = std::function<Result<void>(std::string_view space, std::string_view name,
                                                const XmlAttributes& attributes)>;

/// Walks through an XML part of an archive. When `take` refuses an element, the message begins with part and
/// line.
Result<void> read_xml(ZipArchive& archive, const std::string& part, const ElementTaker& take);

}  // namespace psicarve::model
