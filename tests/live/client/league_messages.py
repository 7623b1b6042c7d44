"""The league's messages as classes, compiled by protoc from the files in messages/."""
import pathlib
import subprocess
import types

from google.protobuf import descriptor_pb2, message_factory

FOLDER = pathlib.Path(__file__).resolve().parent / "messages"


def compiled():
    """A namespace of all messages."""
    files = sorted(str(file) for file in FOLDER.glob("*.proto"))
    protoc = ["protoc", f"-I{FOLDER}", "--include_imports", "--descriptor_set_out=/dev/stdout", *files]
    output = subprocess.run(protoc, stdout=subprocess.PIPE, check=True, timeout=60).stdout
    descriptors = descriptor_pb2.FileDescriptorSet.FromString(output)
    classes = message_factory.GetMessages(descriptors.file)
    return types.SimpleNamespace(**{name.rpartition(".")[2]: value for name, value in classes.items()})
