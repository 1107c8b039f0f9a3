#include "framework/support/Fingerprint.h"

#include <array>
#include <bit>
#include <openssl/evp.h>
#include <stdexcept>

namespace mrpp
{

static_assert(std::endian::native == std::endian::little, "fingerprints hash numbers as little-endian bytes");

namespace
{

/// Looked up once: that takes as long as hashing a short text.
const EVP_MD *sha256()
{
    static const EVP_MD *const algorithm = EVP_MD_fetch(nullptr, "SHA256", nullptr);
    return algorithm;
}

} // namespace

struct Fingerprint::State
{
    EVP_MD_CTX *context = EVP_MD_CTX_new();

    State()
    {
        if (context == nullptr || EVP_DigestInit_ex(context, sha256(), nullptr) != 1)
            throw std::runtime_error("SHA-256 is not available");
    }
    ~State() { EVP_MD_CTX_free(context); }
    State(const State &) = delete;
    State &operator=(const State &) = delete;

    void update(const void *data, std::size_t bytes) { EVP_DigestUpdate(context, data, bytes); }

    std::array<unsigned char, EVP_MAX_MD_SIZE> digest()
    {
        std::array<unsigned char, EVP_MAX_MD_SIZE> result{};
        unsigned int size = 0;
        EVP_DigestFinal_ex(context, result.data(), &size);
        return result;
    }
};

Fingerprint::Fingerprint() : state_(std::make_unique<State>()) {}
Fingerprint::~Fingerprint() = default;
Fingerprint::Fingerprint(Fingerprint &&) noexcept = default;
Fingerprint &Fingerprint::operator=(Fingerprint &&) noexcept = default;

Fingerprint &Fingerprint::add(std::string_view text)
{
    add(static_cast<std::uint64_t>(text.size()));
    state_->update(text.data(), text.size());
    return *this;
}

Fingerprint &Fingerprint::add(std::uint64_t number)
{
    state_->update(&number, sizeof number);
    return *this;
}

Fingerprint &Fingerprint::add(double number)
{
    return add(std::bit_cast<std::uint64_t>(number));
}

Fingerprint &Fingerprint::add(std::span<const std::uint32_t> numbers)
{
    add(static_cast<std::uint64_t>(numbers.size()));
    state_->update(numbers.data(), numbers.size_bytes());
    return *this;
}

std::string Fingerprint::hex()
{
    constexpr std::string_view digits = "0123456789abcdef";
    const auto digest = state_->digest();
    std::string text;
    for (std::size_t i = 0; i < 16; ++i)
    {
        text += digits[digest[i] >> 4];
        text += digits[digest[i] & 15];
    }
    return text;
}

std::uint64_t Fingerprint::bits()
{
    const auto digest = state_->digest();
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < 8; ++i)
        value |= static_cast<std::uint64_t>(digest[i]) << (8 * i);
    return value;
}

} // namespace mrpp
