"""The parts of a WebSocket client and of HTTP that the tests of `kerfline serve` require."""
import base64
import os
import re
import socket
import struct

TEXT, BINARY, CLOSE = 1, 2, 8


def http(port, path="/", **names):
    """Returns (status, whole answer as bytes) of a GET."""
    status, answer, link = request(port, path, **names)
    link.close()
    return status, answer


def post(port, path, body, length=None, **names):
    """Returns (status, body of the answer) of a POST that announces `length`, or the length of its body."""
    extra = f"Content-Length: {len(body) if length is None else length}\r\n"
    status, answer, link = request(port, path, method="POST", extra=extra, body=body, **names)
    link.close()
    return status, answer.split(b"\r\n\r\n", 1)[1]


def head(port, path="/"):
    """Returns (head, following bytes) of a HEAD request, until the server closes the connection."""
    link = socket.create_connection(("127.0.0.1", port), timeout=20)
    link.sendall(f"HEAD {path} HTTP/1.1\r\nHost: 127.0.0.1:{port}\r\n\r\n".encode())
    answer = b""
    while part := link.recv(65536):
        answer += part
    link.close()
    return tuple(answer.split(b"\r\n\r\n", 1))


def request(port, path, host=None, origin=None, extra="", method="GET", body=b""):
    """Returns the answer and the socket, still open."""
    link = socket.create_connection(("127.0.0.1", port), timeout=120)
    lines = [f"{method} {path} HTTP/1.1", f"Host: {host or f'127.0.0.1:{port}'}"]
    if origin:
        lines.append(f"Origin: {origin}")
    link.sendall(("\r\n".join(lines) + "\r\n" + extra + "\r\n").encode() + body)
    answer = b""
    while b"\r\n\r\n" not in answer:
        part = link.recv(1)
        if not part:
            break
        answer += part
    head = answer.decode().lower()
    if found := re.search(r"content-length:\s*(\d+)", head):
        length = int(found[1])
        content = b""
        while len(content) < length:
            content += link.recv(length - len(content))
        answer += content
    return int(head.split()[1]), answer, link


class WebSocket:
    def __init__(self, port, path="/", **names):
        key = base64.b64encode(os.urandom(16)).decode()
        status, _, self.link = request(port, path, extra=(
            "Upgrade: websocket\r\nConnection: Upgrade\r\n"
            f"Sec-WebSocket-Key: {key}\r\nSec-WebSocket-Version: 13\r\n"), **names)
        self.status = status
        self.text = ""

    def send(self, data, opcode=BINARY):
        mask = os.urandom(4)
        size = bytes([0x80 | len(data)]) if len(data) < 126 else b"\xfe" + struct.pack(">H", len(data))
        masked = bytes(byte ^ mask[index % 4] for index, byte in enumerate(data))
        self.link.sendall(bytes([0x80 | opcode]) + size + mask + masked)

    def exactly(self, count):
        data = b""
        while len(data) < count:
            part = self.link.recv(count - len(data))
            if not part:
                raise EOFError
            data += part
        return data

    def frame(self):
        """Returns (opcode, payload) of the next frame."""
        first, size = self.exactly(2)
        if size == 126:
            size, = struct.unpack(">H", self.exactly(2))
        elif size == 127:
            size, = struct.unpack(">Q", self.exactly(8))
        return first & 15, self.exactly(size)

    def until(self, words):
        """Returns the text up to and including these words."""
        while words not in self.text:
            opcode, data = self.frame()
            if opcode in (TEXT, BINARY):
                self.text += data.decode()
            elif opcode == CLOSE:
                raise EOFError(self.text)
        place = self.text.index(words) + len(words)
        found, self.text = self.text[:place], self.text[place:]
        return found

    def close(self):
        self.link.close()
