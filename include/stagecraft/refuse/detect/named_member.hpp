// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <type_traits>

namespace stagecraft::detail {

/// Where `Name::name` and a member of T with that name would be ambiguous; never constructed.
template <class T, class Name>
struct name_beside : T, Name {};

template <class T, class Name>
constexpr bool finds_member_named() {
    if constexpr (std::is_class_v<T> && !std::is_final_v<T>)
        return !Name::template visible_in<name_beside<T, Name>>;
    else if constexpr (std::is_class_v<T> || std::is_union_v<T>)
        return Name::template visible_in<T>;
    else
        return false;
}

/// True if the class T (const or not) has a member of the name that `Name` stands for: data, function,
/// template or type, accessible or not, own or inherited. An optional member that is there and cannot be used as its concept
/// says is then refused rather than passed over. A name is declared as
///
///     struct mass_member {
///         int mass;
///         template <class T>
///         static constexpr bool visible_in = requires { &T::mass; };
///     };
///
/// In classes that are final or unions, from which nothing can be derived, overloaded functions, templates,
/// types and what is not public are not found.
template <class T, class Name>
concept has_member_named = finds_member_named<std::remove_cv_t<T>, Name>();

}  // namespace stagecraft::detail
