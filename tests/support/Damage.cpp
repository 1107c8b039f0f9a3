#include "tests/support/Damage.h"

#include <cstdint>
#include <vector>

namespace mrpp::test
{

std::string damaged(std::string text, Random &random)
{
    static const std::vector<std::string> oddities = {"99999999999999999999",
                                                      "4294967295",
                                                      "4294967296",
                                                      "-1",
                                                      "2147483648",
                                                      "1e308",
                                                      "nan",
                                                      "0x10",
                                                      std::string(1, '\0'),
                                                      "\xFF\xFE",
                                                      "\r",
                                                      "\n",
                                                      "\"",
                                                      "'",
                                                      "{",
                                                      "[",
                                                      std::string(600, '['),
                                                      std::string(600, '{'),
                                                      std::string(300, '<'),
                                                      "<a><b>",
                                                      ": ",
                                                      "- ",
                                                      "&a ",
                                                      "*a",
                                                      "--->",
                                                      ",,,,",
                                                      "1000000",
                                                      "999999999w",
                                                      "\t",
                                                      "  "};
    const std::uint64_t damages = 1 + random.below(3);
    for (std::uint64_t i = 0; i < damages && !text.empty(); ++i)
    {
        const auto at = static_cast<std::size_t>(random.below(text.size()));
        const auto length = static_cast<std::size_t>(1 + random.below(20));
        switch (random.below(7))
        {
        case 0:
            text.resize(at);
            break;
        case 1:
            text[at] = static_cast<char>(random.below(256));
            break;
        case 2:
            text.erase(at, length);
            break;
        case 3:
            text.insert(at, text.substr(static_cast<std::size_t>(random.below(text.size())), 4 * length));
            break;
        case 4:
            text.insert(at, oddities[static_cast<std::size_t>(random.below(oddities.size()))]);
            break;
        case 5: { // a number becomes another
            const std::size_t digit = text.find_first_of("0123456789", at);
            if (digit != std::string::npos)
                text.replace(digit, 1, oddities[static_cast<std::size_t>(random.below(5))]);
            break;
        }
        default: { // a piece many times
            const std::string piece = text.substr(at, length);
            for (int repetition = 0; repetition < 200; ++repetition)
                text.insert(at, piece);
        }
        }
    }
    return text;
}

} // namespace mrpp::test
