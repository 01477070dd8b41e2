"""What a protocol took away from another one."""

from burnish.v1 import common_pb2, editing_pb2, library_pb2
from google.protobuf import descriptor_pb2

FILES = (common_pb2, library_pb2, editing_pb2)
Field = descriptor_pb2.FieldDescriptorProto


def this_protocol():
    """Returns the descriptors of the protocol of this tree."""
    found = descriptor_pb2.FileDescriptorSet()
    for file in FILES:
        file.DESCRIPTOR.CopyToProto(found.file.add())
    return found


def facts_of(protocol):
    """Returns {what: how it travels} of all fields, enum values and calls."""
    found = {}
    for file in protocol.file:
        for message in file.message_type:
            found.update(_facts_of_message(f".{file.package}.{message.name}", message))
        for enum in file.enum_type:
            found.update(_facts_of_enum(f".{file.package}.{enum.name}", enum))
        for service in file.service:
            for method in service.method:
                found[f".{file.package}.{service.name}/{method.name}"] = (
                    method.input_type, method.output_type,
                    "streams" if method.client_streaming else "one",
                    "streams" if method.server_streaming else "one")
    return found


def _facts_of_message(name, message):
    found = {}
    for field in message.field:
        choice = message.oneof_decl[field.oneof_index].name if field.HasField("oneof_index") else ""
        found[f"{name}.{field.name}"] = (field.number, Field.Type.Name(field.type),
                                         Field.Label.Name(field.label), field.type_name, choice)
    for inner in message.nested_type:
        found.update(_facts_of_message(f"{name}.{inner.name}", inner))
    for enum in message.enum_type:
        found.update(_facts_of_enum(f"{name}.{enum.name}", enum))
    return found


def _facts_of_enum(name, enum):
    return {f"{name}.{value.name}": (value.number,) for value in enum.value}


def losses(before, after):
    """Returns what an older client misses: what is gone, and what travels in another way."""
    old, new = facts_of(before), facts_of(after)
    return [f"{what} is gone" for what in old if what not in new] + [
        f"{what} was {old[what]} and is {new[what]}" for what in old
        if what in new and old[what] != new[what]]
