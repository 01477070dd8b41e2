#include "client/web/core/messages/message.h"

#include <algorithm>

namespace burnish::messages {
namespace {

template <typename T>
Slot slot_of(std::unique_ptr<T> owned) {
  return reinterpret_cast<uintptr_t>(owned.release());
}

template <typename T>
const T kNothing{};

}  // namespace

/// Calls act(pointer) with what the slot owns, if it owns anything.
template <typename Act>
void Message::on_owned(const Field& field, Slot slot, const Act& act) {
  const bool is_text = field.kind == Kind::kString || field.kind == Kind::kBytes;
  const bool is_message = field.kind == Kind::kMessage;
  if (slot == 0) return;
  if (!field.is_repeated) {
    if (is_text) act(pointer<std::string>(slot));
    if (is_message) act(pointer<Message>(slot));
  } else if (is_text) {
    act(pointer<Texts>(slot));
  } else if (is_message) {
    act(pointer<Children>(slot));
  } else {
    act(pointer<Numbers>(slot));
  }
}

Message::Message(const Message& other) : type_(other.type_) {
  copy_slots(other);
}

Message::Message(Message&& other) noexcept
    : type_(other.type_), slots_(std::exchange(other.slots_, kDefaults)) {}

Message& Message::operator=(const Message& other) {
  Message copy(other);
  std::swap(slots_, copy.slots_);
  return *this;
}

Message& Message::operator=(Message&& other) noexcept {
  Message taken(std::move(other));
  std::swap(slots_, taken.slots_);
  return *this;
}

Message::~Message() {
  release();
}

void Message::copy_slots(const Message& other) {
  if (other.slots_ == kDefaults) return;
  own_slots();
  std::copy_n(other.slots_, type_->slots, slots_);
  for (size_t n = 0; n < type_->fields.size(); ++n) {
    on_owned(type_->fields[n], slots_[n], [&]<typename T>(const T* held) {
      if constexpr (std::is_same_v<T, Message>) {
        auto copy = held->type_->make();
        *copy = *held;
        slots_[n] = slot_of(std::move(copy));
      } else if constexpr (std::is_same_v<T, Children>) {
        auto copies = std::make_unique<Children>();
        for (const auto& child : *held) {
          copies->push_back(child->type_->make());
          *copies->back() = *child;
        }
        slots_[n] = slot_of(std::move(copies));
      } else {
        slots_[n] = slot_of(std::make_unique<T>(*held));
      }
    });
  }
}

void Message::release() {
  if (slots_ == kDefaults) return;
  for (size_t n = 0; n < type_->fields.size(); ++n)
    on_owned(type_->fields[n], slots_[n], [](auto* held) { delete held; });
  delete[] std::exchange(slots_, kDefaults);
}

Slot* Message::own_slots() {
  if (slots_ == kDefaults) slots_ = new Slot[type_->slots]();
  return slots_;
}

Slot& Message::slot_to_write(size_t n) {
  own_slots();
  const Field& field = type_->fields[n];
  if (field.oneof == kNoOneof || slots_[field.oneof] == field.number) return slots_[n];
  for (size_t other = 0; other < type_->fields.size(); ++other) {
    if (type_->fields[other].oneof != field.oneof) continue;
    on_owned(type_->fields[other], slots_[other], [](auto* held) { delete held; });
    slots_[other] = 0;
  }
  slots_[field.oneof] = field.number;
  return slots_[n];
}

template <typename T>
T& Message::owned(Slot& slot) {
  if (slot == 0) slot = slot_of(std::make_unique<T>());
  return *pointer<T>(slot);
}

const std::string& Message::get_text(size_t field) const {
  return slots_[field] == 0 ? kNothing<std::string> : *pointer<std::string>(slots_[field]);
}

const Numbers& Message::get_numbers(size_t field) const {
  return slots_[field] == 0 ? kNothing<Numbers> : *pointer<Numbers>(slots_[field]);
}

const Texts& Message::get_texts(size_t field) const {
  return slots_[field] == 0 ? kNothing<Texts> : *pointer<Texts>(slots_[field]);
}

const Children& Message::get_messages(size_t field) const {
  return slots_[field] == 0 ? kNothing<Children> : *pointer<Children>(slots_[field]);
}

void Message::put_bits(size_t field, uint64_t bits) {
  slot_to_write(field) = bits;
}

std::string& Message::edit_text(size_t field) {
  return owned<std::string>(slot_to_write(field));
}

Message& Message::edit_message(size_t field) {
  Slot& slot = slot_to_write(field);
  if (slot == 0) slot = slot_of(type_->fields[field].message->make());
  return *pointer<Message>(slot);
}

void Message::append_bits(size_t field, uint64_t bits) {
  owned<Numbers>(slot_to_write(field)).push_back(bits);
}

std::string& Message::append_text(size_t field) {
  return owned<Texts>(slot_to_write(field)).emplace_back();
}

Message& Message::append_message(size_t field) {
  auto& children = owned<Children>(slot_to_write(field));
  return *children.emplace_back(type_->fields[field].message->make());
}

}  // namespace burnish::messages
