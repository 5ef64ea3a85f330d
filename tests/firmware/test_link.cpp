// Requests and answers: identity, ids, ring, back-pressure, events.
#include <cstring>
#include <initializer_list>

#include "device.hpp"
#include "unit.hpp"

namespace {

using fake::Answer;
using fake::Device;
using fake::kNonce;
namespace wire = reliefscope::wire;
using wire::ErrorCode;

wire::LoadLightRequest light(std::uint8_t slot, std::uint16_t level) {
  wire::LoadLightRequest request;
  request.slot = slot;
  request.levels_count = 1;
  request.levels[0] = level;
  return request;
}

}  // namespace

TEST(link_hello_is_answered_under_any_nonce) {
  Device device(wire::ResetCause::kWatchdog);
  for (const std::uint32_t nonce : {std::uint32_t{0}, kNonce, ~kNonce}) {
    device.send(wire::HelloRequest{}, 99, nonce);
    wire::HelloReply reply;
    CHECK(device.answer(99, reply).any);
    CHECK(reply.protocol_version == wire::kProtocolVersion);
    CHECK(std::memcmp(reply.schema_hash, wire::kSchemaHash, sizeof reply.schema_hash) == 0);
    CHECK(reply.boot_nonce == kNonce);
    CHECK(reply.reset_cause == wire::ResetCause::kWatchdog);
    CHECK(reply.last_request_id == 0);
    CHECK(reply.leds == 16);
    CHECK(std::strncmp(reply.board, "fake", sizeof reply.board) == 0);
  }
}

TEST(link_refuses_another_boots_nonce) {
  Device device;
  device.send(light(0, 100), 1, kNonce + 1);
  wire::LoadLightReply reply;
  const Answer answer = device.answer(1, reply);
  CHECK(answer.any && answer.code == ErrorCode::kWrongNonce);
  CHECK(answer.message == wire::MessageId::kRejected);
  CHECK(device.counters().wrong_nonce == 1);
  // It left no trace: the slot is empty, and the id is free.
  wire::SelectLightRequest select;
  CHECK(device.code<wire::SelectLightReply>(select) == ErrorCode::kSlotEmpty);
}

TEST(link_answers_a_retry_from_the_ring_and_never_runs_it_again) {
  Device device;
  device.send(light(3, 100), 10);
  wire::LoadLightReply first;
  CHECK(device.answer(10, first).any && first.level_sum == 100);
  device.send(light(3, 200), 11);
  wire::LoadLightReply second;
  CHECK(device.answer(11, second).any && second.level_sum == 200);
  device.send(light(3, 100), 10);
  wire::LoadLightReply retry;
  CHECK(device.answer(10, retry).any);
  CHECK(retry.level_sum == 100 && retry.crc32 == first.crc32);
  device.last_id = 11;
  wire::SelectLightRequest select;
  select.slot = 3;
  wire::SelectLightReply selected;
  CHECK(device.ask(select, selected).any && selected.level_sum == 200);
  CHECK(device.counters().retries_answered == 1);
}

TEST(link_keeps_sixteen_answers_and_rejects_what_is_older) {
  Device device;
  for (std::uint32_t id = 1; id <= wire::kCompletionRing + 1; ++id) {
    device.send(light(0, static_cast<std::uint16_t>(id)), id);
    wire::LoadLightReply reply;
    CHECK(device.answer(id, reply).any);
  }
  wire::LoadLightReply reply;
  device.send(light(0, 2), 2);
  Answer answer = device.answer(2, reply);
  CHECK(answer.any && answer.code == ErrorCode::kOk && reply.level_sum == 2);
  device.send(light(0, 1), 1);
  answer = device.answer(1, reply);
  CHECK(answer.code == ErrorCode::kRequestTooOld);
  CHECK(answer.detail == wire::kCompletionRing + 1);
}

TEST(link_rejects_a_late_request_whose_id_was_skipped) {
  Device device;
  wire::LoadLightReply reply;
  device.send(light(0, 1), 20);
  CHECK(device.answer(20, reply).code == ErrorCode::kOk);
  device.send(light(0, 2), 19);
  CHECK(device.answer(19, reply).code == ErrorCode::kRequestTooOld);
  device.send(light(0, 2), 0);
  CHECK(device.answer(0, reply).code == ErrorCode::kRequestTooOld);
}

TEST(link_rejects_an_id_used_for_something_else) {
  Device device;
  wire::LoadLightReply reply;
  device.send(light(0, 1), 5);
  CHECK(device.answer(5, reply).code == ErrorCode::kOk);
  device.send(light(0, 2), 5);
  CHECK(device.answer(5, reply).code == ErrorCode::kRequestIdReused);
  device.last_id = 5;
  wire::SelectLightReply selected;
  CHECK(device.ask(wire::SelectLightRequest{}, selected).any && selected.level_sum == 1);
}

TEST(link_keeps_a_failure_but_not_a_rejection) {
  Device device;
  wire::SelectLightReply reply;
  device.send(wire::SelectLightRequest{}, 1);  // slot 0 is empty
  Answer answer = device.answer(1, reply);
  CHECK(answer.code == ErrorCode::kSlotEmpty && answer.message == wire::MessageId::kFailed);
  // Loaded meanwhile: the retry still gets the answer of the first run.
  wire::LoadLightReply loaded;
  device.send(light(0, 1), 2);
  CHECK(device.answer(2, loaded).code == ErrorCode::kOk);
  device.send(wire::SelectLightRequest{}, 1);
  CHECK(device.answer(1, reply).code == ErrorCode::kSlotEmpty);
  // Out of range: rejected, and the id stays free for a proper request.
  wire::SelectLightRequest bad;
  bad.slot = 200;
  device.send(bad, 3);
  answer = device.answer(3, reply);
  CHECK(answer.code == ErrorCode::kOutOfRange && answer.message == wire::MessageId::kRejected);
  device.send(wire::SelectLightRequest{}, 3);
  CHECK(device.answer(3, reply).code == ErrorCode::kOk);
}

TEST(link_rejects_unknown_messages_and_wrong_lengths) {
  Device device;
  wire::StatusReply reply;
  device.send(0x3F, 1, kNonce, nullptr, 0);
  Answer answer = device.answer(1, reply);
  CHECK(answer.any && answer.code == ErrorCode::kUnknownMessage);
  const std::uint8_t extra[3] = {};
  device.send(static_cast<std::uint8_t>(wire::MessageId::kStatusRequest), 2, kNonce, extra, 3);
  answer = device.answer(2, reply);
  CHECK(answer.any && answer.code == ErrorCode::kBadLength);
  CHECK(device.counters().rejected == 2);
}

TEST(link_does_not_answer_its_own_echo) {
  Device device;
  fake::Frame frame;
  CHECK(device.receive(frame));  // the booted event
  const std::uint8_t echo[1] = {static_cast<std::uint8_t>(wire::ResetCause::kPowerOn)};
  device.send(static_cast<std::uint8_t>(wire::MessageId::kBootedEvent), 0, kNonce, echo, 1);
  device.send(static_cast<std::uint8_t>(wire::MessageId::kRejected), 0, kNonce, echo, 1);
  CHECK(!device.receive(frame));
}

TEST(link_counts_a_wrong_length_field_as_framing_error) {
  Device device;
  std::uint8_t body[wire::kMaxFrame] = {};
  std::uint8_t encoded[wire::kMaxEncodedFrame];
  wire::Header header;
  header.message = static_cast<std::uint8_t>(wire::MessageId::kStatusRequest);
  header.boot_nonce = kNonce;
  header.length = 5;
  wire::encode(header, body);
  device.hal.feed(encoded, reliefscope::frame_encode(body, wire::kHeaderSize, encoded));
  device.run_for(0);
  const wire::CountersReply counters = device.counters();
  CHECK(counters.framing_errors == 1);
  CHECK(counters.frames_received == 1);  // the counters request itself
}

TEST(link_first_event_is_booted_and_ends_a_torn_frame) {
  Device device(wire::ResetCause::kBrownOut);
  CHECK(device.hal.tx_size > 0 && device.hal.tx[0] == 0);
  device.collect_events();
  wire::BootedEvent event;
  CHECK(device.event(0, event));
  CHECK(event.reset_cause == wire::ResetCause::kBrownOut);
  CHECK(device.events[0].header.request_id == 0);
}

TEST(link_waits_for_the_port_and_reads_nothing_meanwhile) {
  Device device;
  device.collect_events();
  device.hal.tx_limit = 10;
  for (std::uint32_t id = 1; id <= 3; ++id) {
    device.send(wire::StatusRequest{}, id);
  }
  CHECK(device.hal.tx_size == 10);
  device.hal.tx_limit = sizeof device.hal.tx;
  device.run_for(0);
  wire::StatusReply reply;
  for (std::uint32_t id = 1; id <= 3; ++id) {
    CHECK(device.answer(id, reply).any);
  }
}

TEST(link_sends_an_event_again_on_request) {
  Device device;
  device.collect_events();
  wire::AcknowledgeEventsRequest request;
  request.next_event = 0;
  request.resend = true;
  wire::AcknowledgeEventsReply reply;
  CHECK(device.ask(request, reply).code == ErrorCode::kOk);
  CHECK(reply.oldest_event == 0 && reply.next_event == 1);
  device.collect_events();
  CHECK(device.events.size() == 2);
  CHECK(device.events[1].header.request_id == 0);
  request.next_event = 1;
  CHECK(device.ask(request, reply).code == ErrorCode::kOk && reply.oldest_event == 1);
  request.next_event = 0;
  CHECK(device.ask(request, reply).code == ErrorCode::kEventGone);
  request.next_event = 5;
  CHECK(device.ask(request, reply).code == ErrorCode::kEventGone);
  const wire::CountersReply counters = device.counters();
  CHECK(counters.events_sent == 1 && counters.events_resent == 1);
}

TEST(link_enters_the_bootloader_after_its_answer) {
  Device device;
  wire::EnterBootloaderRequest request;
  wire::EnterBootloaderReply reply;
  device.send(request, 1, 0);
  CHECK(device.answer(1, reply).code == ErrorCode::kBadMagic);
  request.magic = wire::kBootloaderMagic;
  device.send(request, 2, 0);
  CHECK(device.answer(2, reply).code == ErrorCode::kOk);
  CHECK(!device.hal.rebooted);
  device.run_for(std::uint64_t{reply.delay_ms} * 1000);
  CHECK(device.hal.rebooted);
}

TEST(link_says_so_where_there_is_no_bootloader) {
  Device device;
  device.hal.board.capabilities = 0;
  wire::EnterBootloaderRequest request;
  request.magic = wire::kBootloaderMagic;
  CHECK(device.code<wire::EnterBootloaderReply>(request) == ErrorCode::kNoBootloader);
}
