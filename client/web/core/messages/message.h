#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <memory>
#include <ranges>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

// Messages of protobuf for browsers. protoc-gen-messages makes their classes, with the functions
// that protobuf's own have. A class has a table of its fields in place of code: one reader and one
// writer serve all, and protobuf's runtime stays out of the core.
//
// As in protobuf: a field that is not there has its default, unknown fields are passed over, the
// last member of a oneof counts, texts are UTF-8. Otherwise: unknown fields are not kept, and
// groups, which proto3 has not, are refused.

namespace burnish::messages {

class Message;

enum class Kind : uint8_t {
  kBool,
  kInt32,  // also enums
  kInt64,
  kUint32,
  kUint64,
  kSint32,
  kFixed32,
  kFloat,
  kDouble,
  kString,
  kBytes,
  kMessage,
};

struct MessageType;

struct Field {
  uint16_t number;
  Kind kind;
  bool is_repeated;
  uint8_t oneof;  // slot with the number of the oneof's member that is there, or kNoOneof
  const MessageType* message = nullptr;  // of kMessage
};

inline constexpr uint8_t kNoOneof = 0xff;

struct MessageType {
  std::span<const Field> fields;  // by number
  size_t slots;                   // of a message: one a field, then one a oneof
  std::unique_ptr<Message> (*make)();
};

/// A number's bits, or a pointer to what the message owns. 0: the field has its default.
using Slot = uint64_t;

/// Limit of MessageType::slots.
inline constexpr size_t kSlotsMax = 32;

using Numbers = std::vector<uint64_t>;  // bits
using Texts = std::vector<std::string>;
using Children = std::vector<std::unique_ptr<Message>>;

template <typename Number>
Number number_of(uint64_t bits) {
  if constexpr (std::is_same_v<Number, double>)
    return std::bit_cast<double>(bits);
  else if constexpr (std::is_same_v<Number, float>)
    return std::bit_cast<float>(static_cast<uint32_t>(bits));
  else
    return static_cast<Number>(bits);
}

template <typename Number>
uint64_t bits_of(Number number) {
  if constexpr (std::is_same_v<Number, double>)
    return std::bit_cast<uint64_t>(number);
  else if constexpr (std::is_same_v<Number, float>)
    return std::bit_cast<uint32_t>(number);
  else if constexpr (std::is_same_v<Number, bool> || std::is_unsigned_v<Number>)
    return number;
  else
    return static_cast<uint64_t>(static_cast<int64_t>(number));
}

/// Reads items of a repeated field as values.
template <typename Value, typename Item>
class Repeated {
 public:
  class Iterator {
   public:
    using iterator_category = std::input_iterator_tag;
    using value_type = std::remove_cvref_t<Value>;
    using difference_type = std::ptrdiff_t;
    using pointer = void;
    using reference = Value;

    Iterator() = default;
    explicit Iterator(const Item* item) : item_(item) {}
    Value operator*() const { return value(*item_); }
    Iterator& operator++() {
      ++item_;
      return *this;
    }
    Iterator operator++(int) { return Iterator(item_++); }
    bool operator==(const Iterator&) const = default;

   private:
    const Item* item_ = nullptr;
  };

  explicit Repeated(const std::vector<Item>& items) : items_(items) {}
  Iterator begin() const { return Iterator(items_.data()); }
  Iterator end() const { return Iterator(items_.data() + items_.size()); }
  int size() const { return static_cast<int>(items_.size()); }
  Value operator[](int i) const { return value(items_[static_cast<size_t>(i)]); }

 private:
  static Value value(const Item& item) {
    if constexpr (std::is_same_v<Item, uint64_t>)
      return number_of<Value>(item);
    else
      return static_cast<Value>(*item);
  }

  const std::vector<Item>& items_;
};

template <typename Number>
using RepeatedNumbers = Repeated<Number, uint64_t>;
template <typename Child>
using RepeatedMessages = Repeated<const Child&, std::unique_ptr<Message>>;

/// Base of the messages. Its own functions begin with get_, has_a_, put_, append_ or edit_, so that
/// no field hides them.
class Message {
 public:
  Message(const Message& other);
  Message(Message&& other) noexcept;
  Message& operator=(const Message& other);
  Message& operator=(Message&& other) noexcept;
  virtual ~Message();

  /// Takes the place of all fields. False: the bytes are no such message, and what the fields are
  /// is not said.
  bool ParseFromArray(const void* bytes, int size);
  bool ParseFromString(const std::string& bytes) {
    return ParseFromArray(bytes.data(), static_cast<int>(bytes.size()));
  }
  std::string SerializeAsString() const;

 protected:
  constexpr explicit Message(const MessageType& type) : type_(&type) {}

  // `field` is the place of a field in the type's table.

  template <typename Number>
  Number get_number(size_t field) const {
    return number_of<Number>(slots_[field]);
  }
  const std::string& get_text(size_t field) const;
  template <typename Child>
  const Child& get_message(size_t field, const Child& absent) const {
    return slots_[field] == 0 ? absent
                              : static_cast<const Child&>(*pointer<Message>(slots_[field]));
  }
  const Numbers& get_numbers(size_t field) const;
  const Texts& get_texts(size_t field) const;
  const Children& get_messages(size_t field) const;
  bool has_a_message(size_t field) const { return slots_[field] != 0; }
  /// Returns the number of the oneof's member that is there, or 0.
  uint32_t get_member(size_t oneof) const { return static_cast<uint32_t>(slots_[oneof]); }

  void put_bits(size_t field, uint64_t bits);
  std::string& edit_text(size_t field);
  Message& edit_message(size_t field);
  void append_bits(size_t field, uint64_t bits);
  std::string& append_text(size_t field);
  Message& append_message(size_t field);

 private:
  friend class MessageReader;
  friend class MessageWriter;

  template <typename T>
  static T* pointer(Slot slot) {
    return reinterpret_cast<T*>(static_cast<uintptr_t>(slot));
  }
  template <typename Act>
  static void on_owned(const Field& field, Slot slot, const Act& act);

  /// Makes slots of its own for what is written.
  Slot* own_slots();
  /// Returns the slot of a field that is to be there; of its oneof no other member is then.
  Slot& slot_to_write(size_t field);
  template <typename T>
  T& owned(Slot& slot);
  void copy_slots(const Message& other);
  void release();

  static inline Slot kDefaults[kSlotsMax] = {};  // nobody writes them

  const MessageType* type_;
  Slot* slots_ = kDefaults;
};

template <typename Child>
std::unique_ptr<Message> make_message() {
  return std::make_unique<Child>();
}

/// A message that is there before the program begins and after it ends.
template <typename Child>
union Constant {
  constexpr Constant() : message() {}
  ~Constant() {}

  Child message;
};

}  // namespace burnish::messages

template <typename Value, typename Item>
inline constexpr bool std::ranges::enable_borrowed_range<burnish::messages::Repeated<Value, Item>> =
    true;
