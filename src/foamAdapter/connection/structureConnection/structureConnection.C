// SPDX-License-Identifier: GPL-3.0-or-later
#include "structureConnection.H"
#include "Time.H"
#include "openfoamVersion.H"
#include "HashSet.H"
#include "OSspecific.H"
#include "dictionaryChecks.H"
#include "channel/handshake/readToken.hpp"
#include "channel/handshake/shakeHands.hpp"
#include "common/errors.hpp"
#include "common/version.hpp"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace tokay::channel;

//- How long a structure may take to end by itself, in seconds
constexpr double patience = 10;

//- Path of a file that is named from the case folder
Foam::fileName fromCase(const Foam::fileName& name, const Foam::Time& runTime)
{
    Foam::fileName path(name);
    path.expand();
    if (!path.isAbsolute())
    {
        path = runTime.globalPath()/path;
    }
    path.clean();
    return path;
}

} // End anonymous namespace

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::fileName Foam::structureConnection::chooseLog
(
    const dictionary& dict,
    const fileName& caseFile,
    const Time& runTime
) const
{
    static HashSet<fileName> taken;

    fileName log(caseFile.path()/"log.igaStructure");
    if (dict.found("log"))
    {
        log = fromCase(dict.get<fileName>("log"), runTime);
    }
    else if (taken.found(log))
    {
        log += "." + dict_.dictName();
    }
    if (!taken.insert(log))
    {
        FatalIOErrorInFunction(dict)
            << "the log " << log << " is that of another structure: choose "
            << "another 'log'" << exit(FatalIOError);
    }
    return log;
}


void Foam::structureConnection::launch
(
    const dictionary& dict,
    const Time& runTime
)
{
    const fileName caseFile(fromCase(dict.get<fileName>("case"), runTime));
    const fileName log(chooseLog(dict, caseFile, runTime));

    std::vector<std::string> arguments{"run", caseFile};
    for
    (
        const string& word
      : dict.lookupOrDefault<List<string>>("arguments", List<string>())
    )
    {
        arguments.push_back(word);
    }

    const string program
    (
        dict.lookupOrDefault<string>("program", "igaStructure")
    );

    onMaster
    (
        [&]
        {
            process_.reset(new structureProcess(program, arguments, log));
            channel_.reset
            (
                new Channel
                (
                    Channel::fromFileDescriptor(process_->takeFileDescriptor())
                )
            );
        }
    );
    Info<< "    launched " << program.c_str() << ", log " << log << endl;
}


void Foam::structureConnection::connect(const dictionary& dict)
{
    const string address(dict.get<string>("connect"));
    onMaster
    (
        [&] { channel_.reset(new Channel(Channel::connect(address))); }
    );
    Info<< "    connected to " << address.c_str() << endl;
}


void Foam::structureConnection::onMaster(const std::function<void()>& action)
{
    string error;
    if (Pstream::master())
    {
        try
        {
            action();
        }
        catch (const PeerError& peerError)
        {
            error = peerError.what();
            if (channel_ && !dynamic_cast<const PeerFailure*>(&peerError))
            {
                channel_->trySend(Failure{error});
            }
            closeChannel();
            const std::string how(process_ ? process_->end(patience) : "");
            if (!how.empty())
            {
                error += error.back() == '.' ? "\n    " : ".\n    ";
                error += how;
            }
        }
        catch (const std::exception& ownError)
        {
            error = ownError.what();
        }
    }
    fromMaster(error);

    if (!error.empty())
    {
        fail(error);
    }
}


void Foam::structureConnection::closeChannel()
{
    notice_.reset();
    channel_.reset();
}


void Foam::structureConnection::raise(const std::string& text) const
{
    if (!Pstream::master())
    {
        // The master speaks for all, and its end is that of this rank
        IPstream(Pstream::commsTypes::scheduled, Pstream::masterNo());
    }
    if (starting_)
    {
        FatalIOErrorInFunction(dict_) << text.c_str() << exit(FatalIOError);
    }
    FatalErrorInFunction << text.c_str() << exit(FatalError);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::structureConnection::structureConnection
(
    const dictionary& dict,
    const Time& runTime
)
:
    dict_(dict),
    starting_(true)
{
    const dictionary& structureDict = dict.subDict("structure");
    requireKnownEntries
    (
        structureDict,
        {
            "launch", "case", "program", "arguments", "log", "connect",
            "tokenFile", "silenceInterval"
        }
    );

    std::string token;
    if (structureDict.found("tokenFile"))
    {
        onMaster
        (
            [&]
            {
                token = readToken
                (
                    fromCase(structureDict.get<fileName>("tokenFile"), runTime)
                );
            }
        );
    }

    if (structureDict.found("connect"))
    {
        if (structureDict.lookupOrDefault("launch", false))
        {
            FatalIOErrorInFunction(structureDict)
                << "'launch yes' and 'connect' exclude each other: "
                << "remove one of the two" << exit(FatalIOError);
        }
        connect(structureDict);
    }
    else
    {
        launch(structureDict, runTime);
    }

    notice_.reset
    (
        new abortNotifier(channel_ ? channel_->fileDescriptor() : -1)
    );

    const scalar silence =
        structureDict.lookupOrDefault<scalar>("silenceInterval", 60);

    onMaster
    (
        [&]
        {
            channel_->reportSilence
            (
                silence,
                [](const std::string& line)
                {
                    Info<< "structureCoupling: " << line.c_str() << endl;
                }
            );

            Hello own;
            own.role = Role::fluid;
            own.program = std::string("Tokay ") + tokay::version;
            const Hello peer(shakeHands(*channel_, own, token));
            Info<< "    structure: " << peer.program.c_str() << ", case digest "
                << peer.caseDigest.c_str() << endl;
        }
    );
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

tokay::channel::Accepted Foam::structureConnection::start
(
    const Interface& interface
)
{
    agreement_ = Agreement(interface);
    Accepted accepted;
    onMaster
    (
        [&]
        {
            channel_->send(interface);
            accepted = channel_->receive<Accepted>
            (
                "the structure to accept the interface"
            );
        }
    );
    starting_ = false;
    return accepted;
}


tokay::channel::Displacements Foam::structureConnection::exchange
(
    const Message& message,
    const std::string& waitingFor
)
{
    Displacements displacements;
    onMaster
    (
        [&]
        {
            channel_->send(message);
            displacements = channel_->receive<Displacements>(waitingFor);
            requireUsable(displacements, message, agreement_);
            if
            (
                displacements.state == State::rejected
             && displacements.reason.empty()
            )
            {
                displacements.reason =
                    "the structure has no solution, and gives no reason";
            }
        }
    );
    return displacements;
}


void Foam::structureConnection::reject(const std::string& reason)
{
    onMaster([&] { channel_->send(RejectStep{reason}); });
}


void Foam::structureConnection::fail(const std::string& text)
{
    if (channel_)
    {
        channel_->trySend(Failure{text});
        closeChannel();
    }
    raise(text);
}


void Foam::structureConnection::close(const std::string& reason)
{
    onMaster
    (
        [&]
        {
            channel_->send(Goodbye{reason});
            // Answered when all output of the structure is safe
            channel_->receive<Goodbye>("the structure to end");
            closeChannel();
            const std::string how(process_ ? process_->end(patience) : "");
            if (!how.empty())
            {
                throw tokay::SolverError(how);
            }
        }
    );
}


// ************************************************************************* //
