// Structs of the C interface from and to those of the C++ interface, with the rule of sizes (glint/glint.h).
#pragma once

#include "base/result.hpp"
#include "c_api/members.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>
#include <optional>
#include <span>
#include <type_traits>
#include <vector>

namespace glint::c_api {

/// Longest struct that a newer header may have; a greater size was never initialized.
constexpr uint32_t kLongestStruct = 4096;

template <class T>
constexpr bool isStdArray = false;
template <class T, size_t n>
constexpr bool isStdArray<std::array<T, n>> = true;

/// Writes C++ values into C members. Images and other structs by pointer become null: absent.
struct ToC {
    template <class C, class Cpp>
    void pair(const char* /*name*/, C& c, const Cpp& cpp) {
        if constexpr (std::is_pointer_v<C> && std::is_class_v<Cpp>)
            c = nullptr;
        else if constexpr (std::is_array_v<C>)
            std::copy(std::begin(cpp), std::end(cpp), std::begin(c));
        else if constexpr (std::is_same_v<Cpp, std::optional<VkImageViewType>>)
            c = cpp.value_or(VK_IMAGE_VIEW_TYPE_MAX_ENUM);
        else if constexpr (std::is_class_v<Cpp>)
            members(*this, c, const_cast<Cpp&>(cpp));
        else
            c = static_cast<C>(cpp);
    }
};

/// The C struct with the values of the C++ struct.
template <class Cpp>
typename CStruct<Cpp>::Type toC(const Cpp& cpp) {
    using C = typename CStruct<Cpp>::Type;
    C c = {};
    c.size = sizeof(C);
    ToC visitor;
    members(visitor, c, const_cast<Cpp&>(cpp)); // ToC only reads it
    return c;
}

/// Writes as many members as the host's struct has. `size` is the host's.
template <class C>
void writeStruct(C from, C* to, uint32_t size) {
    from.size = size;
    std::memset(static_cast<void*>(to), 0, size);
    std::memcpy(static_cast<void*>(to), &from, std::min<size_t>(size, sizeof(C)));
}

/// glint_..._init. A size that no struct has is ignored: reading the struct then reports it.
template <class Cpp, class C>
void initStruct(C* to, uint32_t size) {
    static_assert(std::is_same_v<C, typename CStruct<Cpp>::Type>);
    if (to && size >= sizeof(uint32_t) && size <= kLongestStruct)
        writeStruct(toC(Cpp()), to, size);
}

/// Checks the size of a struct that the host passes. `extra`: bytes that this library does not know.
inline Result<void> checkSize(const char* name, const void* in, uint32_t size, size_t known) {
    if (size < 2 * sizeof(uint32_t) || size > kLongestStruct)
        return invalidArgument("{}::size is {}, the library's {}: initialize the struct before use", name, size, known);
    const auto* bytes = static_cast<const unsigned char*>(in);
    for (size_t i = known; i < size; ++i)
        if (bytes[i] != 0)
            return invalidArgument("{}: the host sets members that this library, {}.{}.{}, does not have", name,
                                   GLINT_VERSION_MAJOR, GLINT_VERSION_MINOR, GLINT_VERSION_PATCH);
    return {};
}

/// The host's struct with the library's size: members that it lacks have their defaults.
template <class Cpp>
Result<typename CStruct<Cpp>::Type> wholeStruct(const typename CStruct<Cpp>::Type* in) {
    using C = typename CStruct<Cpp>::Type;
    if (!in)
        return invalidArgument("{} is null", CStruct<Cpp>::kName);
    uint32_t size = 0;
    std::memcpy(&size, in, sizeof size);
    GLINT_CHECK(checkSize(CStruct<Cpp>::kName, in, size, sizeof(C)));
    C whole = toC(Cpp());
    std::memcpy(static_cast<void*>(&whole), in, std::min<size_t>(size, sizeof(C)));
    return whole;
}

template <class Cpp>
Result<Cpp> readStruct(const typename CStruct<Cpp>::Type* in);

/// Reads C members into C++ values; keeps the first error.
class FromC {
public:
    explicit FromC(const char* structName) : structName_(structName) {}

    template <class C, class Cpp>
    void pair(const char* name, const C& c, Cpp& cpp) {
        if constexpr (std::is_pointer_v<C> && std::is_class_v<Cpp>) {
            if (!c) // absent: the C++ struct's default stays
                return;
            if (auto read = readStruct<Cpp>(c))
                cpp = *std::move(read);
            else
                refuse(invalidArgument("{}::{}: {}", structName_, name, read.error().message));
        } else if constexpr (std::is_array_v<C>) {
            std::copy(std::begin(c), std::end(c), std::begin(cpp));
        } else if constexpr (std::is_same_v<Cpp, bool>) {
            cpp = c != 0;
        } else if constexpr (std::is_same_v<Cpp, std::optional<VkImageViewType>>) {
            cpp = c == VK_IMAGE_VIEW_TYPE_MAX_ENUM ? std::nullopt : std::optional(c);
        } else if constexpr (std::is_class_v<Cpp>) {
            members(*this, const_cast<C&>(c), cpp); // FromC only reads it
        } else if constexpr (std::is_enum_v<Cpp> && !std::is_same_v<C, Cpp>) {
            const auto number = static_cast<uint32_t>(c);
            if (number > static_cast<uint32_t>(lastOf(cpp)))
                return refuse(invalidArgument("{}::{} is {}: at most {}", structName_, name, number,
                                              static_cast<uint32_t>(lastOf(cpp))));
            cpp = static_cast<Cpp>(number);
        } else if constexpr (std::is_same_v<Cpp, uint8_t>) {
            if (c > std::numeric_limits<uint8_t>::max())
                return refuse(invalidArgument("{}::{} is {}: at most 255", structName_, name, c));
            cpp = static_cast<uint8_t>(c);
        } else {
            cpp = c;
        }
    }

    const Result<void>& result() const { return result_; }

private:
    void refuse(Error error) {
        if (result_)
            result_ = std::move(error);
    }

    const char* structName_;
    Result<void> result_;
};

/// Errors: InvalidArgument names the struct, the member and what is wrong with it.
template <class Cpp>
Result<Cpp> readStruct(const typename CStruct<Cpp>::Type* in) {
    GLINT_TRY(whole, wholeStruct<Cpp>(in));
    Cpp cpp;
    FromC visitor(CStruct<Cpp>::kName);
    members(visitor, whole, cpp);
    if (!visitor.result())
        return visitor.result().error();
    return cpp;
}

/// A host's array of structs, whose elements have the size of the first.
template <class C>
class HostArray {
public:
    HostArray(const C* first, uint32_t count) : bytes_(reinterpret_cast<const unsigned char*>(first)), count_(count) {
        if (first)
            std::memcpy(&stride_, bytes_, sizeof stride_);
    }
    uint32_t count() const { return count_; }
    const C* operator[](uint32_t i) const { return reinterpret_cast<const C*>(bytes_ + size_t{i} * stride_); }

    /// Errors: InvalidArgument for a null array with a count, or elements of other sizes than the first.
    Result<void> check(const char* name) const {
        if (count_ > 0 && !bytes_)
            return invalidArgument("{} {}, but the array is null", count_, name);
        for (uint32_t i = 0; i < count_; ++i) {
            uint32_t size = 0;
            std::memcpy(&size, (*this)[i], sizeof size);
            if (size != stride_ || size < 2 * sizeof(uint32_t) || size > kLongestStruct)
                return invalidArgument("{} {}: size is {}, the first one's {}: initialize each struct before use", name,
                                       i, size, stride_);
        }
        return {};
    }

private:
    const unsigned char* bytes_;
    uint32_t count_;
    uint32_t stride_ = 0;
};

/// Errors: InvalidArgument names the element.
template <class Cpp>
Result<std::vector<Cpp>> readArray(const typename CStruct<Cpp>::Type* first, uint32_t count) {
    const HostArray array(first, count);
    GLINT_CHECK(array.check(CStruct<Cpp>::kName));
    std::vector<Cpp> list;
    list.reserve(count);
    for (uint32_t i = 0; i < count; ++i) {
        auto read = readStruct<Cpp>(array[i]);
        if (!read)
            return invalidArgument("{} {}: {}", CStruct<Cpp>::kName, i, read.error().message);
        list.push_back(*std::move(read));
    }
    return list;
}

/// Writes a result into the host's struct, whose size is set. Errors: InvalidArgument for a null struct or its size.
template <class Cpp>
Result<void> checkResultStruct(const typename CStruct<Cpp>::Type* out) {
    if (!out)
        return invalidArgument("the {} for the result is null", CStruct<Cpp>::kName);
    uint32_t size = 0;
    std::memcpy(&size, out, sizeof size);
    if (size < 2 * sizeof(uint32_t) || size > kLongestStruct)
        return invalidArgument("{}::size is {}, the library's {}: initialize the struct before use",
                               CStruct<Cpp>::kName, size, sizeof(*out));
    return {};
}

} // namespace glint::c_api
