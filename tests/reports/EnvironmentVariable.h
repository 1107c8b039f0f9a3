#pragma once
/// \file
/// A variable of the environment, changed for as long as this lives.

#include <cstdlib>
#include <string>

namespace mrpp::testing
{

/// Sets an environment variable for as long as it lives.
class EnvironmentVariable
{
public:
    EnvironmentVariable(const char *name, const std::string &value) : name_(name)
    {
        if (const char *before = std::getenv(name))
            before_ = before;
        ::setenv(name, value.c_str(), 1);
    }
    ~EnvironmentVariable() { ::setenv(name_, before_.c_str(), 1); }
    EnvironmentVariable(const EnvironmentVariable &) = delete;
    EnvironmentVariable &operator=(const EnvironmentVariable &) = delete;

private:
    const char *name_;
    std::string before_;
};

} // namespace mrpp::testing
