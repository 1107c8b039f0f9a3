// `threads COUNT MEGABYTES [SECONDS]` starts that many threads with stacks of 8 MB, each of which waits, and
// fills that much memory, as published planners do that start a thread a robot.

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <pthread.h>
#include <thread>
#include <unistd.h>
#include <vector>

namespace
{

void *wait(void *)
{
    for (;;)
        ::pause();
}

} // namespace

int main(int count, char **words)
{
    if (count < 3)
        return 2;
    constexpr std::size_t kStack = std::size_t{8} << 20;
    pthread_attr_t attributes;
    ::pthread_attr_init(&attributes);
    ::pthread_attr_setstacksize(&attributes, kStack);
    for (int i = std::atoi(words[1]); i > 0; --i)
    {
        pthread_t thread{};
        if (::pthread_create(&thread, &attributes, wait, nullptr) != 0)
        {
            std::perror("thread");
            return 3;
        }
    }
    std::vector<std::vector<char>> filled;
    for (int i = std::atoi(words[2]); i > 0; --i)
        filled.emplace_back(1'000'000, 'x');
    std::this_thread::sleep_for(std::chrono::duration<double>(count > 3 ? std::atof(words[3]) : 0));
    std::_Exit(0);
}
