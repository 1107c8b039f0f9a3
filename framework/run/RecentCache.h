#pragma once
/// \file
/// The last few results of an expensive function, for several threads: one makes a value, the others that
/// want the same wait for it, and nobody else waits.

#include <algorithm>
#include <deque>
#include <future>
#include <mutex>
#include <string>
#include <utility>

namespace mrpp
{

template <class T>
class RecentCache
{
public:
    using Cost = std::size_t (*)(const T &);

    /// \param capacity how many values to keep; 1 or more
    /// \param budget more are kept as long as they cost no more than this together
    explicit RecentCache(std::size_t capacity, Cost cost = nullptr, std::size_t budget = 0)
        : capacity_(capacity), cost_(cost), budget_(budget)
    {}

    /// The value under that key, made by `make()` where it is not among the last few. What make() throws
    /// reaches all who wait for it, and the next caller tries again.
    template <class Make>
    T get(const std::string &key, Make &&make)
    {
        std::promise<T> promise;
        {
            std::unique_lock lock(mutex_);
            const auto found = find(key);
            if (found != entries_.end())
            {
                const std::shared_future<T> value = found->value;
                lock.unlock();
                return value.get();
            }
            entries_.push_back({key, promise.get_future().share(), 0});
            trim();
        }
        try
        {
            T value = make();
            promise.set_value(value);
            const std::lock_guard lock(mutex_);
            if (const auto found = find(key); found != entries_.end() && cost_ != nullptr)
                found->cost = cost_(value);
            trim();
            return value;
        }
        catch (...)
        {
            promise.set_exception(std::current_exception());
            const std::lock_guard lock(mutex_);
            if (const auto found = find(key); found != entries_.end())
                entries_.erase(found);
            throw;
        }
    }

private:
    struct Entry
    {
        std::string key;
        std::shared_future<T> value;
        std::size_t cost = 0; ///< 0 while it is being made
    };

    auto find(const std::string &key)
    {
        return std::find_if(entries_.begin(), entries_.end(),
                            [&key](const Entry &entry) { return entry.key == key; });
    }

    void trim()
    {
        std::size_t total = 0;
        for (const Entry &entry : entries_)
            total += entry.cost;
        while (entries_.size() > capacity_ && (cost_ == nullptr || total > budget_))
        {
            total -= entries_.front().cost;
            entries_.pop_front();
        }
    }

    std::size_t capacity_;
    Cost cost_;
    std::size_t budget_;
    std::mutex mutex_;
    std::deque<Entry> entries_; // oldest first
};

} // namespace mrpp
