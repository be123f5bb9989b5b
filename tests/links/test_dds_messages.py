"""The messages of the DDS link against rosbags, which writes and names ROS 2 messages without Cyclone DDS."""

import math
from dataclasses import fields
from functools import cache
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from rosbags.interfaces import Nodetype
from rosbags.typesys import Stores, get_typestore
from rosbags.typesys.store import Typestore

from pinel_desktop.links.dds import messages
from pinel_desktop.links.dds.messages import (
    TYPE_HASHES,
    Range,
    RangeBeforeIron,
    ros_name,
    type_name,
)

# Releases of ROS 2 on robots; endpoints tell type hashes since Iron (REP 2016). Within a row all definitions are equal.
BEFORE_IRON = (Stores.ROS2_FOXY, Stores.ROS2_HUMBLE)
SINCE_IRON = (Stores.ROS2_IRON, Stores.ROS2_JAZZY, Stores.ROS2_KILTED, Stores.LATEST)
CASES = [
    (store, RangeBeforeIron if message is Range and store in BEFORE_IRON else message)
    for store in (Stores.ROS2_HUMBLE, Stores.ROS2_JAZZY)
    for message in TYPE_HASHES
]
NUMBERS = {
    "bool": st.booleans(),
    "float32": st.floats(width=32),
    "float64": st.floats(),
    "int32": st.integers(-(2**31), 2**31 - 1),
    "uint32": st.integers(0, 2**32 - 1),
    "uint8": st.integers(0, 255),
    "string": st.text(
        st.characters(exclude_characters="\0", exclude_categories=["Cs"]), max_size=12
    ),
}


@cache
def typestore(store: Stores) -> Typestore:
    return get_typestore(store)


def values(store: Stores, kind: Any) -> st.SearchStrategy[Any]:
    """Random values of a field as rosbags describes it: a message is the dictionary of its fields."""
    node, detail = kind
    if node == Nodetype.BASE:
        return NUMBERS[detail[0]]
    if node == Nodetype.NAME:
        return message_values(store, detail)
    item, n = detail
    return st.lists(values(store, item), min_size=n, max_size=n or 8)


def message_values(store: Stores, name: str) -> st.SearchStrategy[dict[str, Any]]:
    _, described = typestore(store).fielddefs[name]
    return st.fixed_dictionaries({field: values(store, kind) for field, kind in described})


def of_rosbags(store: Stores, name: str, value: dict[str, Any]) -> Any:
    """The same message as an object of rosbags."""
    _, described = typestore(store).fielddefs[name]
    made = {field: _rosbags_field(store, kind, value[field]) for field, kind in described}
    return typestore(store).types[name](**made)


def _rosbags_field(store: Stores, kind: Any, value: Any) -> Any:
    node, detail = kind
    if node == Nodetype.NAME:
        return of_rosbags(store, detail, value)
    if node == Nodetype.BASE:
        return value
    (item_node, item), _ = detail
    if item_node == Nodetype.NAME:
        return [of_rosbags(store, item, one) for one in value]
    return np.array(value, item[0])


def of_ours(message: type[Any], value: dict[str, Any]) -> Any:
    """The same message as an object of ours; messages in it are made by the types of its own defaults."""
    return message(**{field: _our_field(message, field, value[field]) for field in value})


def _our_field(message: type[Any], field: str, value: Any) -> Any:
    if isinstance(value, dict):
        return of_ours(type(getattr(message(), field)), value)
    if isinstance(value, list) and value and isinstance(value[0], dict):
        item = {"points": messages.Point32, "channels": messages.ChannelFloat32}[field]
        return [of_ours(item, one) for one in value]
    return value


def holds(message: Any, value: Any) -> bool:
    """True if a message of either library has these values; NaN equals NaN."""
    if isinstance(value, dict):
        return all(holds(getattr(message, field), item) for field, item in value.items())
    if isinstance(value, list):
        return len(message) == len(value) and all(map(holds, message, value))
    if isinstance(value, float) and math.isnan(value):
        return math.isnan(message)
    return bool(message == value)


@pytest.mark.parametrize(("store", "message"), CASES)
def test_bytes_are_those_of_rosbags_in_both_directions(store: Stores, message: type[Any]) -> None:
    name = ros_name(type_name(message))

    @given(message_values(store, name))
    def check(value: dict[str, Any]) -> None:
        theirs = bytes(typestore(store).serialize_cdr(of_rosbags(store, name, value), name))
        ours = of_ours(message, value).serialize(use_version_2=False)
        assert ours == theirs
        assert holds(message.deserialize(theirs), value)
        assert holds(typestore(store).deserialize_cdr(ours, name), value)

    check()


@pytest.mark.parametrize(("store", "message"), CASES)
def test_fields_have_the_names_and_the_order_of_ros(store: Stores, message: type[Any]) -> None:
    _, described = typestore(store).fielddefs[ros_name(type_name(message))]
    assert [field.name for field in fields(message)] == [field for field, _ in described]


@pytest.mark.parametrize("store", SINCE_IRON)
@pytest.mark.parametrize("message", TYPE_HASHES)
def test_type_hashes_are_those_that_rosbags_computes(store: Stores, message: type[Any]) -> None:
    assert TYPE_HASHES[message] == typestore(store).hash_rihs01(ros_name(type_name(message)))


def test_before_iron_all_definitions_but_that_of_range_were_the_same() -> None:
    assert RangeBeforeIron not in TYPE_HASHES
    for store in BEFORE_IRON:
        computed = {
            message: typestore(store).hash_rihs01(ros_name(type_name(message)))
            for message in TYPE_HASHES
        }
        assert [
            message for message in TYPE_HASHES if computed[message] != TYPE_HASHES[message]
        ] == [Range]


@pytest.mark.parametrize("message", [*TYPE_HASHES, RangeBeforeIron])
def test_names_of_types_are_those_of_the_ros_middleware(message: type[Any]) -> None:
    name = ros_name(type_name(message))
    package, kind, short = name.split("/")
    assert type_name(message) == f"{package}::{kind}::dds_::{short}_"
    assert name in typestore(Stores.LATEST).types
