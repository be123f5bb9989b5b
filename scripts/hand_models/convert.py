"""Converts TensorFlow Lite to ONNX, for the operators that MediaPipe's two hand networks use.

tf2onnx needs the whole of TensorFlow, and tflite2onnx has had no release since 2022. These networks are plain
convolutions with float16 weights, so this file translates each operator once. A tensor of rank 4 is NHWC in TensorFlow
Lite and NCHW here; inputs and outputs of the graph have the layout of the original. The weights stay float16 in the
file and are cast when the graph is loaded.
"""

from collections.abc import Callable, Mapping, Sequence
from typing import Any

import numpy as np
import onnx
import tflite
from numpy.typing import NDArray
from onnx import TensorProto, helper, numpy_helper

OPSET = 17
IR_VERSION = 8
_NCHW, _NHWC = (0, 3, 1, 2), (0, 2, 3, 1)
_NONE, _RELU6 = tflite.ActivationFunctionType.NONE, tflite.ActivationFunctionType.RELU6
_DTYPES = {
    tflite.TensorType.FLOAT32: np.dtype("<f4"),
    tflite.TensorType.FLOAT16: np.dtype("<f2"),
    tflite.TensorType.INT32: np.dtype("<i4"),
}


class ConversionError(Exception):
    """The network has an operator or activation without a translation here."""


def convert(content: bytes, inputs: Sequence[str], outputs: Mapping[str, int]) -> bytes:
    """Converts the first subgraph of a .tflite file to an ONNX file.

    `inputs` names the inputs in their order. `outputs` names the output tensors, by their number. Raises
    ConversionError.
    """
    source = _Source(content)
    target = _Target()
    given = dict(zip(inputs, source.inputs, strict=True))
    for name, tensor in given.items():
        target.add("Transpose", [name], _name(tensor), perm=_NCHW)
    for operator in source.operators():
        if operator.kind not in _OPERATORS:
            raise ConversionError(f"operator {operator.kind}")
        _OPERATORS[operator.kind](source, target, operator)
    for name, tensor in outputs.items():
        if len(source.shape(tensor)) == 4:
            target.add("Transpose", [_name(tensor)], name, perm=_NHWC)
        else:
            target.add("Identity", [_name(tensor)], name)
    return target.as_file(
        {name: source.shape(tensor) for name, tensor in given.items()},
        {name: source.shape(tensor) for name, tensor in outputs.items()},
    )


class _Operator:
    """One operator of the original: its kind, the numbers of its tensors, its options."""

    def __init__(self, kind: str, table: Any) -> None:
        self.kind = kind
        self.inputs: list[int] = table.InputsAsNumpy().tolist()
        self.output: int = table.OutputsAsNumpy().tolist()[0]
        self._options = table.BuiltinOptions()

    def options(self, kind: Any) -> Any:
        parsed = kind()
        parsed.Init(self._options.Bytes, self._options.Pos)
        return parsed


class _Source:
    """Reads the original; shapes are NHWC."""

    def __init__(self, content: bytes) -> None:
        self._model = tflite.Model.GetRootAs(content, 0)
        self._graph = self._model.Subgraphs(0)
        self._float16: dict[int, int] = {}  # dequantized tensor -> tensor with its values
        self.inputs: list[int] = self._graph.InputsAsNumpy().tolist()

    def operators(self) -> list[_Operator]:
        """Returns the operators that compute, in their order; resolves DEQUANTIZE of weights."""
        found = []
        for i in range(self._graph.OperatorsLength()):
            table = self._graph.Operators(i)
            code = self._model.OperatorCodes(table.OpcodeIndex())
            kind = tflite.opcode2name(max(code.BuiltinCode(), code.DeprecatedBuiltinCode()))
            operator = _Operator(kind, table)
            if kind == "DEQUANTIZE":
                self._float16[operator.output] = operator.inputs[0]
            else:
                found.append(operator)
        return found

    def shape(self, tensor: int) -> list[int]:
        return [int(n) for n in self._graph.Tensors(tensor).ShapeAsNumpy()]

    def constant(self, tensor: int) -> NDArray[Any]:
        """Returns the values of a tensor that does not depend on the input; weights as float16.

        Raises ConversionError.
        """
        tensor = self._float16.get(tensor, tensor)
        info = self._graph.Tensors(tensor)
        content = self._model.Buffers(info.Buffer()).DataAsNumpy()
        if isinstance(content, int) or info.Type() not in _DTYPES:
            raise ConversionError(f"tensor {tensor} is no constant of a known type")
        values: NDArray[Any] = content.view(_DTYPES[info.Type()]).reshape(self.shape(tensor))
        return values


class _Target:
    """Collects nodes and weights of the ONNX graph."""

    def __init__(self) -> None:
        self._nodes: list[onnx.NodeProto] = []
        self._constants: list[TensorProto] = []

    def add(
        self,
        kind: str,
        inputs: Sequence[str],
        output: str,
        *,
        activation: int = _NONE,
        **attributes: Any,
    ) -> None:
        """Adds a node, and a node for a fused activation. Raises ConversionError for an unknown activation."""
        if activation not in (_NONE, _RELU6):
            raise ConversionError(f"activation {activation}")
        computed = output if activation == _NONE else f"{output}_linear"
        self._nodes.append(helper.make_node(kind, inputs, [computed], output, **attributes))
        if activation == _RELU6:
            bounds = [self.constant(np.float32(v), f"{output}_{v}") for v in (0, 6)]
            self._nodes.append(
                helper.make_node("Clip", [computed, *bounds], [output], f"{output}_6")
            )

    def constant(self, values: Any, name: str) -> str:
        """Adds values, and a cast to float32 if they are float16; returns their name in the graph."""
        values = np.ascontiguousarray(values) if np.ndim(values) else np.asarray(values)
        stored = f"{name}_half" if values.dtype == np.float16 else name
        self._constants.append(numpy_helper.from_array(values, stored))
        if stored != name:
            self.add("Cast", [stored], name, to=TensorProto.FLOAT)
        return name

    def as_file(self, inputs: Mapping[str, list[int]], outputs: Mapping[str, list[int]]) -> bytes:
        graph = helper.make_graph(
            self._nodes, "hand", _described(inputs), _described(outputs), self._constants
        )
        opset = helper.make_opsetid("", OPSET)
        model = helper.make_model(graph, opset_imports=[opset], ir_version=IR_VERSION)
        onnx.checker.check_model(model, full_check=True)
        return bytes(model.SerializeToString(deterministic=True))


def _described(shapes: Mapping[str, list[int]]) -> list[onnx.ValueInfoProto]:
    return [
        helper.make_tensor_value_info(name, TensorProto.FLOAT, shape)
        for name, shape in shapes.items()
    ]


def _name(tensor: int) -> str:
    return f"t{tensor}"


def _names(operator: _Operator) -> list[str]:
    return [_name(tensor) for tensor in operator.inputs]


def _window(
    source: _Source, operator: _Operator, options: Any, size: Sequence[int]
) -> dict[str, Any]:
    """Returns strides and padding of a sliding window of `size` (height, width); SAME puts the odd pixel at the end."""
    strides = (options.StrideH(), options.StrideW())
    before, after = source.shape(operator.inputs[0])[1:3], source.shape(operator.output)[1:3]
    missing = [
        max((n_out - 1) * stride + extent - n_in, 0)
        if options.Padding() == tflite.Padding.SAME
        else 0
        for n_in, n_out, stride, extent in zip(before, after, strides, size, strict=True)
    ]
    starts = [pixels // 2 for pixels in missing]
    ends = [pixels - start for pixels, start in zip(missing, starts, strict=True)]
    return {"kernel_shape": list(size), "strides": strides, "pads": starts + ends}


def _convolution(source: _Source, target: _Target, operator: _Operator) -> None:
    """Adds a convolution. A kernel is OHWI in the original and OIHW here, a depthwise kernel 1HWC and C1HW."""
    depthwise = operator.kind == "DEPTHWISE_CONV_2D"
    options = operator.options(tflite.DepthwiseConv2DOptions if depthwise else tflite.Conv2DOptions)
    image, kernel, bias = operator.inputs
    output = _name(operator.output)
    values = source.constant(kernel)
    weights = values.transpose((3, 0, 1, 2) if depthwise else _NCHW)
    target.add(
        "Conv",
        [
            _name(image),
            target.constant(weights, f"{output}_kernel"),
            target.constant(source.constant(bias), f"{output}_bias"),
        ],
        output,
        activation=options.FusedActivationFunction(),
        group=values.shape[3] if depthwise else 1,
        **_window(source, operator, options, values.shape[1:3]),
    )


def _max_pool(source: _Source, target: _Target, operator: _Operator) -> None:
    options = operator.options(tflite.Pool2DOptions)
    size = (options.FilterHeight(), options.FilterWidth())
    window = _window(source, operator, options, size)
    target.add("MaxPool", _names(operator), _name(operator.output), **window)


def _prelu(source: _Source, target: _Target, operator: _Operator) -> None:
    """Adds a PReLU with one slope for each channel: 11C -> C11."""
    image, slope = operator.inputs
    output = _name(operator.output)
    slopes = target.constant(source.constant(slope).transpose(2, 0, 1), f"{output}_slope")
    target.add("PRelu", [_name(image), slopes], output)


def _add(_source: _Source, target: _Target, operator: _Operator) -> None:
    activation = operator.options(tflite.AddOptions).FusedActivationFunction()
    target.add("Add", _names(operator), _name(operator.output), activation=activation)


def _pad(source: _Source, target: _Target, operator: _Operator) -> None:
    image, amounts = operator.inputs
    output = _name(operator.output)
    channels_second = source.constant(amounts)[list(_NCHW)].T.astype(np.int64).ravel()
    pads = target.constant(channels_second, f"{output}_pads")
    target.add("Pad", [_name(image), pads], output)


def _resize(source: _Source, target: _Target, operator: _Operator) -> None:
    options = operator.options(tflite.ResizeBilinearOptions)
    if options.AlignCorners() or not options.HalfPixelCenters():
        raise ConversionError("RESIZE_BILINEAR without half pixel centres")
    output = _name(operator.output)
    n, height, width, channels = source.shape(operator.output)
    size = target.constant(np.array([n, channels, height, width], np.int64), f"{output}_size")
    target.add("Resize", [_name(operator.inputs[0]), "", "", size], output, mode="linear")


def _reshape(source: _Source, target: _Target, operator: _Operator) -> None:
    """Adds a reshape; in the flattened order, rows and columns precede channels."""
    image, output = operator.inputs[0], _name(operator.output)
    if len(source.shape(image)) != 4:
        raise ConversionError("RESHAPE of what is no picture")
    target.add("Transpose", [_name(image)], f"{output}_nhwc", perm=_NHWC)
    shape = target.constant(np.array(source.shape(operator.output), np.int64), f"{output}_shape")
    target.add("Reshape", [f"{output}_nhwc", shape], output)


def _concatenation(source: _Source, target: _Target, operator: _Operator) -> None:
    if len(source.shape(operator.output)) == 4:
        raise ConversionError("CONCATENATION of pictures")
    axis = operator.options(tflite.ConcatenationOptions).Axis()
    target.add("Concat", _names(operator), _name(operator.output), axis=axis)


def _mean(source: _Source, target: _Target, operator: _Operator) -> None:
    image, axes = operator.inputs
    if sorted(source.constant(axes)) != [1, 2]:
        raise ConversionError("MEAN over other axes than rows and columns")
    target.add("ReduceMean", [_name(image)], _name(operator.output), axes=[2, 3], keepdims=0)


def _fully_connected(source: _Source, target: _Target, operator: _Operator) -> None:
    image, kernel, bias = operator.inputs
    output = _name(operator.output)
    weights = target.constant(source.constant(kernel), f"{output}_kernel")
    offsets = target.constant(source.constant(bias), f"{output}_bias")
    activation = operator.options(tflite.FullyConnectedOptions).FusedActivationFunction()
    target.add("Gemm", [_name(image), weights, offsets], output, activation=activation, transB=1)


def _logistic(_source: _Source, target: _Target, operator: _Operator) -> None:
    target.add("Sigmoid", _names(operator), _name(operator.output))


_OPERATORS: dict[str, Callable[[_Source, _Target, _Operator], None]] = {
    "ADD": _add,
    "CONCATENATION": _concatenation,
    "CONV_2D": _convolution,
    "DEPTHWISE_CONV_2D": _convolution,
    "FULLY_CONNECTED": _fully_connected,
    "LOGISTIC": _logistic,
    "MAX_POOL_2D": _max_pool,
    "MEAN": _mean,
    "PAD": _pad,
    "PRELU": _prelu,
    "RESHAPE": _reshape,
    "RESIZE_BILINEAR": _resize,
}
