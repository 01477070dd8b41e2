#pragma once

#include <ranges>
#include <string_view>
#include <type_traits>

// A record is a struct whose fields have the same names in messages and in JSON. One list behind
// the struct names them, in the order of JSON:
//
//   struct PreparedInfo { PreparedKey key; uint64_t size_bytes = 0; };
//   BURNISH_RECORD(PreparedInfo, key, size_bytes)
//
// A field that is a record itself, as `key`, lies flat among the others. A field that has another
// name or form in one of the notations is not in the list: each notation writes it.

namespace burnish {

/// Has a list of its fields.
template <typename T>
concept Record = requires(T& record) {
  visit_fields(record, 0);
};

/// Is Type, or constant Type.
template <typename T, typename Type>
concept MaybeConst = std::is_same_v<std::remove_const_t<T>, Type>;

/// Is a repeated field in messages.
template <typename T>
concept RepeatedField = std::ranges::range<T> && !std::is_convertible_v<T, std::string_view>;

/// Sets the members of a JSON object.
template <typename Json, Record T>
void add_fields(const T& record, Json& json) {
  visit_fields(record, [&json](const char* name, const auto& value) { json[name] = value; });
}

template <typename Json, Record T>
Json json_of(const T& record) {
  Json json;
  add_fields(record, json);
  return json;
}

/// Reads the members of a JSON object. Throws, as the JSON does, where one is missing or wrong.
template <typename Json, Record T>
void take_fields(const Json& json, T& record) {
  visit_fields(record, [&json](const char* name, auto& value) { json.at(name).get_to(value); });
}

/// Returns the record of a message. Checks nothing.
template <Record T, typename Message>
T read_record(const Message& message) {
  T record;
  read_fields(message, record);
  return record;
}

template <typename Items, typename Act>
void each_item(const Items& items, const Act& act) {
  for (const auto& item : items) act(item);
}

template <typename From, typename To>
void read_items(const From& from, To& to) {
  to = To(from.begin(), from.end());
}

}  // namespace burnish

/// Defines visit_fields(), which calls visit("name", record.name) for each field; and for messages
/// that have these fields write_fields() and read_fields(), which checks nothing.
#define BURNISH_RECORD(Type, ...)                           \
  template <burnish::MaybeConst<Type> T, typename Visit>    \
  void visit_fields(T& record, const Visit& visit) {        \
    BURNISH_EACH_1(BURNISH_VISIT_FIELD, __VA_ARGS__)        \
  }                                                         \
  template <typename Message>                               \
  void write_fields(const Type& record, Message& message) { \
    BURNISH_EACH_1(BURNISH_WRITE_FIELD, __VA_ARGS__)        \
  }                                                         \
  template <typename Message>                               \
  void read_fields(const Message& message, Type& record) {  \
    BURNISH_EACH_1(BURNISH_READ_FIELD, __VA_ARGS__)         \
  }

#define BURNISH_VISIT_FIELD(name)                       \
  if constexpr (burnish::Record<decltype(record.name)>) \
    visit_fields(record.name, visit);                   \
  else                                                  \
    visit(#name, record.name);

#define BURNISH_WRITE_FIELD(name)                                                         \
  if constexpr (burnish::Record<decltype(record.name)>)                                   \
    write_fields(record.name, message);                                                   \
  else if constexpr (burnish::RepeatedField<decltype(record.name)>)                       \
    burnish::each_item(record.name, [&](const auto& item) { message.add_##name(item); }); \
  else                                                                                    \
    message.set_##name(record.name);

#define BURNISH_READ_FIELD(name)                                    \
  if constexpr (burnish::Record<decltype(record.name)>)             \
    read_fields(message, record.name);                              \
  else if constexpr (burnish::RepeatedField<decltype(record.name)>) \
    burnish::read_items(message.name(), record.name);               \
  else                                                              \
    record.name = message.name();

// Expand to DO(a) DO(b) ... for up to 16 names.
#define BURNISH_EACH_1(DO, a, ...) DO(a) __VA_OPT__(BURNISH_EACH_2(DO, __VA_ARGS__))
#define BURNISH_EACH_2(DO, a, ...) DO(a) __VA_OPT__(BURNISH_EACH_3(DO, __VA_ARGS__))
#define BURNISH_EACH_3(DO, a, ...) DO(a) __VA_OPT__(BURNISH_EACH_4(DO, __VA_ARGS__))
#define BURNISH_EACH_4(DO, a, ...) DO(a) __VA_OPT__(BURNISH_EACH_5(DO, __VA_ARGS__))
#define BURNISH_EACH_5(DO, a, ...) DO(a) __VA_OPT__(BURNISH_EACH_6(DO, __VA_ARGS__))
#define BURNISH_EACH_6(DO, a, ...) DO(a) __VA_OPT__(BURNISH_EACH_7(DO, __VA_ARGS__))
#define BURNISH_EACH_7(DO, a, ...) DO(a) __VA_OPT__(BURNISH_EACH_8(DO, __VA_ARGS__))
#define BURNISH_EACH_8(DO, a, ...) DO(a) __VA_OPT__(BURNISH_EACH_9(DO, __VA_ARGS__))
#define BURNISH_EACH_9(DO, a, ...) DO(a) __VA_OPT__(BURNISH_EACH_10(DO, __VA_ARGS__))
#define BURNISH_EACH_10(DO, a, ...) DO(a) __VA_OPT__(BURNISH_EACH_11(DO, __VA_ARGS__))
#define BURNISH_EACH_11(DO, a, ...) DO(a) __VA_OPT__(BURNISH_EACH_12(DO, __VA_ARGS__))
#define BURNISH_EACH_12(DO, a, ...) DO(a) __VA_OPT__(BURNISH_EACH_13(DO, __VA_ARGS__))
#define BURNISH_EACH_13(DO, a, ...) DO(a) __VA_OPT__(BURNISH_EACH_14(DO, __VA_ARGS__))
#define BURNISH_EACH_14(DO, a, ...) DO(a) __VA_OPT__(BURNISH_EACH_15(DO, __VA_ARGS__))
#define BURNISH_EACH_15(DO, a, ...) DO(a) __VA_OPT__(BURNISH_EACH_16(DO, __VA_ARGS__))
#define BURNISH_EACH_16(DO, a, ...) DO(a) __VA_OPT__(BURNISH_EACH_17(DO, __VA_ARGS__))
