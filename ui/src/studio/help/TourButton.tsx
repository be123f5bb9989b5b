import { Route } from "lucide-preact";
import { api } from "../../api/client";
import { texts } from "../../i18n";
import { Button } from "../../kit/Button";
import { helpIsOpen, tourFor } from "../../shell/help";
import { go } from "../../shell/route";
import type { OpenProgram } from "../program/open_program";
import { useHelpContent } from "./help_content";

/** Starts the guided first drive again. */
export function TourButton() {
  const { open } = useHelpContent();
  return (
    <Button icon={Route} testId="help-tour" onPress={() => begin(open)}>
      {texts.value.help.tour.title}
    </Button>
  );
}

/** Starts it in a program without blocks: the open program if it is empty, else a new one. */
async function begin(open: OpenProgram): Promise<void> {
  if (open.isEmpty && !open.mission.peek()) {
    helpIsOpen.value = false;
    tourFor.value = open.id;
    return;
  }
  const { id } = await api.createProgram(open.program.group_id, texts.value.help.tour.title);
  tourFor.value = id;
  go({ screen: "studio", program: id });
}
