import { Download, Upload } from "lucide-preact";
import { NO_CLASS } from "../api/classes";
import { exchange } from "../api/exchange";
import type { Program } from "../api/model";
import { texts } from "../i18n";
import { labelled } from "../i18n/phrases";
import { Button } from "../kit/Button";
import { setClassroom } from "../shell/classroom";
import { FileButton } from "../shell/files/FileButton";
import { fileName, saveFile } from "../shell/files/save_file";
import { go } from "../shell/route";
import { problem } from "../shell/session";

const SUFFIX = ".pinel";

/** Exports a program as a file, for another PC. */
export function ExportProgram({ program }: { program: Program }) {
  const { programFile } = texts.value;
  const exportFile = async () => {
    const { octets, leftOut } = await exchange.programFile(program.id);
    saveFile(`${fileName(program.name, "programa")}${SUFFIX}`, octets);
    problem.value = leftOut;
  };
  return (
    <Button
      kind="plain"
      icon={Download}
      label={labelled(programFile.takeAlong, program.name)}
      tip={programFile.takeAlongHint}
      testId="program-file"
      onPress={exportFile}
    >
      {programFile.take}
    </Button>
  );
}

/** Imports a program with its group from a file, and opens it. */
export function ImportProgram() {
  const { programFile } = texts.value;
  const importFile = async (file: File) => {
    const brought = await exchange.bringProgram(file);
    setClassroom(brought.classroom_id ?? NO_CLASS);
    go({ screen: "studio", program: brought.program_id });
  };
  return (
    <FileButton
      kind="plain"
      icon={Upload}
      accept={SUFFIX}
      testId="bring-program"
      onFile={importFile}
    >
      {programFile.bringIn}
    </FileButton>
  );
}
