"""Wire protocol between host and device: typed messages (generated) and frames.

``messages`` is generated from protocol/protocol.yml; ``codec`` gives its classes their behaviour; ``framing``
puts payloads into frames and finds them in a stream of bytes.  The reference is docs/reference/protocol.md.
"""
