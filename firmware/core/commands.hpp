// The handlers of all requests: checks what depends on the state, has it done, fills the answer.
// Ranges of fields were checked by the decoder; a code other than OK means that nothing happened.
#pragma once

#include <cstdint>

#include "core/generated/protocol.hpp"
#include "core/hal.hpp"
#include "core/instrument.hpp"
#include "core/link_state.hpp"

namespace reliefscope {

class Commands {
 public:
  Commands(Hal& hal, Instrument& instrument, LinkState& link)
      : hal_(hal), instrument_(instrument), link_(link) {}

  using Error = wire::ErrorCode;
  using Detail = std::uint32_t;

  Error handle(const wire::HelloRequest&, wire::HelloReply&, Detail&);
  Error handle(const wire::EnterBootloaderRequest&, wire::EnterBootloaderReply&, Detail&);
  Error handle(const wire::StatusRequest&, wire::StatusReply&, Detail&);
  Error handle(const wire::LimitsRequest&, wire::LimitsReply&, Detail&);
  Error handle(const wire::LoadLightRequest&, wire::LoadLightReply&, Detail&);
  Error handle(const wire::ApertureChunkRequest&, wire::ApertureChunkReply&, Detail&);
  Error handle(const wire::CommitApertureRequest&, wire::CommitApertureReply&, Detail&);
  Error handle(const wire::SelectApertureRequest&, wire::SelectApertureReply&, Detail&);
  Error handle(const wire::SelectLightRequest&, wire::SelectLightReply&, Detail&);
  Error handle(const wire::AllOffRequest&, wire::AllOffReply&, Detail&);
  Error handle(const wire::StepChunkRequest&, wire::StepChunkReply&, Detail&);
  Error handle(const wire::CommitStepsRequest&, wire::CommitStepsReply&, Detail&);
  Error handle(const wire::StartRequest&, wire::StartReply&, Detail&);
  Error handle(const wire::PauseRequest&, wire::PauseReply&, Detail&);
  Error handle(const wire::ResumeRequest&, wire::ResumeReply&, Detail&);
  Error handle(const wire::AbortRequest&, wire::AbortReply&, Detail&);
  Error handle(const wire::ClearFaultRequest&, wire::ClearFaultReply&, Detail&);
  Error handle(const wire::AcknowledgeEventsRequest&, wire::AcknowledgeEventsReply&, Detail&);
  Error handle(const wire::CountersRequest&, wire::CountersReply&, Detail&);
  Error handle(const wire::GetSettingsRequest&, wire::GetSettingsReply&, Detail&);
  Error handle(const wire::SetSettingsRequest&, wire::SetSettingsReply&, Detail&);
  Error handle(const wire::GetLedCorrectionRequest&, wire::GetLedCorrectionReply&, Detail&);
  Error handle(const wire::SetLedCorrectionRequest&, wire::SetLedCorrectionReply&, Detail&);

 private:
  // OK, or BUSY while a sequence is under way.
  Error idle() const;
  // OK, or NOT_RUNNING unless this run is under way.
  Error running(std::uint32_t run_id, Detail& detail) const;
  Detail fault_number() const;

  Hal& hal_;
  Instrument& instrument_;
  LinkState& link_;
};

}  // namespace reliefscope
