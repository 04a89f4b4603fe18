#ifndef LVSM_TESTS_SUPPORT_RESULT_HPP
#define LVSM_TESTS_SUPPORT_RESULT_HPP

#include <optional>
#include <string>
#include <utility>

namespace lvsm::support
{

struct Failure
{
    std::string message;
};

/// A value, or the reason why there is none.
template <typename T>
class Result
{
public:
    Result(T value) : m_value(std::move(value)) {}
    Result(Failure failure) : m_error(std::move(failure.message)) {}

    explicit operator bool() const { return m_value.has_value(); }
    T& operator*() { return *m_value; }
    const T& operator*() const { return *m_value; }
    T* operator->() { return &*m_value; }
    const T* operator->() const { return &*m_value; }
    const std::string& error() const { return m_error; }

private:
    std::optional<T> m_value;
    std::string m_error;
};

} // namespace lvsm::support

#endif
