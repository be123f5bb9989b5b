; A small program in place of the installer of WebView2, which writes what that one writes.
Target amd64-unicode
OutFile "${OUTPUT}"
RequestExecutionLevel user
SilentInstall silent
!include FileFunc.nsh

Section
  ${GetParameters} $0
  StrCmp $0 "/silent /install" 0 +2
  WriteRegStr HKCU "Software\Microsoft\EdgeUpdate\Clients\{F3017226-FE2A-4295-8BDF-00C3A9A7E4C5}" "pv" "120.0.1.2"
SectionEnd
