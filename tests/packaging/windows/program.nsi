; A small program in place of pinel.exe and pinel-desktop.exe: runs until $TEMP\close-pinel exists.
; With --check it reads the set-up file beside it: status 1 for the line `wrong`.
Target amd64-unicode
OutFile "${OUTPUT}"
RequestExecutionLevel user
SilentInstall silent
!include FileFunc.nsh
!include LogicLib.nsh

Section
  ${GetParameters} $0
  ClearErrors
  ${GetOptions} $0 "--check" $1
  ${If} ${Errors}
    FileOpen $0 "$TEMP\pinel-is-open" w
    FileClose $0
    ${DoUntil} ${FileExists} "$TEMP\close-pinel"
      Sleep 50
    ${Loop}
  ${Else}
    FileOpen $0 "$EXEDIR\setup\pinel.toml" r
    FileRead $0 $1
    FileClose $0
    ${If} $1 == "wrong"
      SetErrorLevel 1
    ${EndIf}
  ${EndIf}
SectionEnd
