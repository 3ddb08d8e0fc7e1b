"""Relays between a sender and a server, which damage bytes on their way."""
import random
import socket
import threading


class Relay:
    """Forwards bytes to a server and back, and damages or drops one in `one_in`."""

    def __init__(self, port, one_in, seed):
        self.listener = socket.create_server(("127.0.0.1", 0))
        self.port, self.target = self.listener.getsockname()[1], port
        self.one_in, self.random, self.damaged = one_in, random.Random(seed), 0
        threading.Thread(target=self.accept, daemon=True).start()

    def accept(self):
        near, _ = self.listener.accept()
        far = socket.create_connection(("127.0.0.1", self.target))
        for source, sink in ((near, far), (far, near)):
            threading.Thread(target=self.carry, args=(source, sink), daemon=True).start()

    def carry(self, source, sink):
        try:
            self.copy(source, sink)
        except OSError:
            pass
        for end in (source, sink):
            try:
                end.shutdown(socket.SHUT_RDWR)
            except OSError:
                pass

    def copy(self, source, sink):
        while data := source.recv(256):
            sink.sendall(bytes(self.spoiled(data)))

    def spoiled(self, data):
        for byte in data:
            if self.random.random() * self.one_in >= 1.0:
                yield byte
                continue
            self.damaged += 1
            if self.random.random() < 0.7:
                yield byte ^ (1 << self.random.randrange(8))


class Rewriter(Relay):
    """Replaces only certain words, in order and each once: pairs (word, other word), one list for
    bytes to the sender and one for bytes to the machine.
    """

    def __init__(self, port, to_sender=(), to_machine=()):
        self.to_sender, self.to_machine = list(to_sender), list(to_machine)
        super().__init__(port, one_in=1, seed=1)

    def copy(self, source, sink):
        changes = self.to_machine if source.getsockname()[1] == self.port else self.to_sender
        line = b""
        while byte := source.recv(1):
            line += byte
            if byte in b"\n?!~>\x18" or len(line) == 1 and line >= b"\x80":
                sink.sendall(self.rewritten(line, changes))
                line = b""

    @staticmethod
    def rewritten(line, changes):
        if changes and changes[0][0] in line:
            return line.replace(*changes.pop(0))
        return line
