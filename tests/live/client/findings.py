"""What checks of packets found."""
import collections

MOST_EXAMPLES = 3


class Findings:
    """Counts how often each check was made, and keeps examples of what failed."""

    def __init__(self):
        self.made, self.failed = collections.Counter(), collections.Counter()
        self.examples = collections.defaultdict(list)
        self.absent, self.present = set(), set()

    def expect(self, check, holds, found=""):
        """Notes that `check` was made; `found` is shown if it failed."""
        self.made[check] += 1
        if not holds:
            self.failed[check] += 1
            if len(self.examples[check]) < MOST_EXAMPLES:
                self.examples[check].append(str(found))

    def expect_within(self, check, value, least, most):
        """NaN is never within."""
        self.expect(check, least <= value <= most, f"{value}, not from {least} to {most}")

    def expect_known(self, check, message):
        """Every field has a number of the message's table."""
        size = message.ByteSize()
        message.DiscardUnknownFields()
        self.expect(check, message.ByteSize() == size, f"{size - message.ByteSize()} bytes of unknown fields")

    def note_fields(self, message):
        """Which optional fields are used, by their path."""
        for field in message.DESCRIPTOR.fields:
            path = f"{message.DESCRIPTOR.name}.{field.name}"
            is_list = field.label == field.LABEL_REPEATED
            value = getattr(message, field.name)
            is_present = len(value) > 0 if is_list else message.HasField(field.name)
            (self.present if is_present else self.absent).add(path)
            if is_present and field.message_type:
                for part in value if is_list else [value]:
                    self.note_fields(part)

    def never_present(self):
        return sorted(self.absent - self.present)
